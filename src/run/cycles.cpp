#include "cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::run {
namespace {

const std::string cycle_numbers = "cycles.numbers", cycle_ranges = "cycles.ranges", cycle_work = "cycles.work",
                  cycle_limits = "cycles.limits";
constexpr double least_life = 0.01;  // that a whole run uses up: smaller ones need no accuracy of their own
const std::string extrapolation_prefix = "cycles.jumps.";

std::vector<std::string> cycle_columns(const creep::Assembly& assembly, const CycleWatch& watch,
                                       const std::vector<config::Probe>& probes) {
  std::vector<std::string> names{"time", "cycle", "jumped", "steps", "elastic_solves", "stress_change"};
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) {
    const std::string& body = assembly.bodies()[b].name();
    names.push_back(body + ".inelastic_strain_range");
    names.push_back(body + ".strain_range");
    for (const material::StateVariable* variable : watch.life_of(b)) {
      names.push_back(fmt::format("{}.{}", body, variable->name));
      names.push_back(fmt::format("{}.{}_per_cycle", body, variable->name));
    }
    if (!watch.life_of(b).empty()) names.push_back(body + ".cycles_to_limit");
  }
  for (const config::Probe& probe : probes)
    for (const char* value : {"min", "max", "end"}) names.push_back(fmt::format("{}_{}", probe.name, value));
  return names;
}

}  // namespace

Cycles::Cycles(const config::Config& config, const model::LoadCycles& loads, creep::CreepSystem& system,
               WholeState& whole, std::span<const std::unique_ptr<results::Probe>> probes,
               const std::filesystem::path& directory, double time, const creep::Memory* memory)
    : config_(config),
      loads_(loads),
      system_(system),
      watch_(system, whole, probes),
      used_up_(system.assembly().bodies().size(), std::numeric_limits<double>::infinity()) {
  summary_.steady_within = config.time.stop_when_steady.value_or(0);
  if (config.time.jump_cycles) jumps_.emplace(system.team(), config.time.jump_tolerance);
  go_to(loads_.ended_by(time));
  if (time > 0 && !loads_.ending_at(time)) stage_ = Stage::waiting;
  if (memory != nullptr) restore(*memory);
  if (memory != nullptr && stage_ == Stage::waiting && loads_.ended_by(time) < loads_.count())
    log::warning(
        "the run is resumed at t = {:.10g}, within cycle {}: what this cycle does up to there is not known, so it has "
        "no "
        "row in cycles.csv and does not count for fatigue",
        time, loads_.ended_by(time) + 1);
  together(system.team(), [&] {
    if (system.team().rank() != 0) return;
    const std::filesystem::path path = directory / "cycles.csv";
    file_ = std::make_unique<io::CsvFile>(
        path, cycle_columns(system.assembly(), watch_, config.probes),
        io::Continuation{.resume = memory != nullptr && path_exists(path), .last_time = time}, config.output.csv);
  });
}

void Cycles::go_to(std::int64_t cycle) {
  cycle_ = cycle;
  stage_ = cycle < loads_.count() ? Stage::between : Stage::waiting;
}

std::int64_t Cycles::longest_jump(std::int64_t cycle, double next_output) const {
  // The last cycle is computed: results there are those of a checked state.
  std::int64_t last = std::min(cycle + jumps_->proposal(), loads_.ended_by(next_output) - 1);
  if (bound_ >= cycle) last = std::min(last, bound_ - 1);
  for (std::int64_t k = cycle; k <= last; ++k)
    if (!loads_.repeats(k)) last = k - 1;
  return std::max<std::int64_t>(last - cycle, 0);
}

std::optional<double> Cycles::jump(double t, double next_output, std::span<double> y) {
  if (!jumps_) return std::nullopt;
  const std::int64_t n = longest_jump(cycle_, next_output);
  if (n == 0) return std::nullopt;
  jumps_->jump(n, y);
  cycle_ += n;
  return std::max(t, loads_.begin(cycle_));
}

void Cycles::begin(double t, std::span<const double> y) {
  stage_ = Stage::within;
  first_.assign(y.begin(), y.end());
  watch_.begin(t, y);
  activity_ = {};
  last_step_ = first_;
}

void Cycles::step(const ode::StepReport& report, std::span<const double> y) {
  if (!is_checking()) return;
  const std::span<const double> scale = system_.scale();
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += std::pow((y[i] - last_step_[i]) / scale[i], 2);
  last_step_.assign(y.begin(), y.end());
  if (const double change = system_.team().sum(sum); change > activity_.change)
    activity_ = {change, report.time - report.step / 2, last_step_};
}

void Cycles::see(double t, std::span<const double> y) {
  if (stage_ == Stage::within) watch_.see(t, y);
}

void Cycles::see_after_jump(double t, std::span<const double> y) {
  if (stage_ == Stage::within && loads_.jumps_at(t)) watch_.see(t, y);
}

ode::CycleExtrapolation::Damping Cycles::damping(std::span<const double> change) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (!(activity_.change > 0)) return {};
  std::vector<double> rate(change.size());
  system_.begin_segment(-never, never);
  try {
    system_.rate(activity_.time, activity_.state, rate);
  } catch (const RecoverableError&) {
    return {};  // the jump is corrected without
  }
  // The time in which the rate there makes what the cycle does.
  const std::span<const double> scale = system_.scale();
  std::array<double, 2> sums{};
  for (std::size_t i = 0; i < change.size(); ++i) {
    const double of_cycle = change[i] / scale[i];
    sums[0] += of_cycle * of_cycle;
    sums[1] += of_cycle * rate[i] / scale[i];
  }
  system_.team().sum(sums);
  const double time = sums[1] * loads_.period() > sums[0] ? sums[0] / sums[1] : loads_.period();
  return [this, time](double weight, std::span<const double> given, std::span<double> damped) {
    system_.precondition_once(activity_.time, activity_.state, weight * time, given, damped);
  };
}

Cycles::Closed Cycles::close(double t, const RunCounters& work, std::span<double> y) {
  const std::optional<std::int64_t> ended = loads_.ending_at(t);
  if (!ended) return {.time = t};
  const bool seen = stage_ == Stage::within;
  go_to(*ended + 1);
  summary_.completed = cycle_;
  if (!seen) {
    if (jumps_) jumps_->begin(cycle_);
    previous_ = -1;
    return {.time = t};
  }
  Closed result{.time = t, .state_changed = watch_.add_cycle(y)};
  const std::vector<double> computed(y.begin(), y.end());
  const std::int64_t jumped = is_checking() ? jumps_->jumped() : 0;
  ++summary_.computed;
  std::vector<double> change = computed;
  for (std::size_t i = 0; i < change.size(); ++i) change[i] -= first_[i];
  system_.resolve_cycle(change, least_life / static_cast<double>(loads_.count()));
  if (jumped > 0) {
    if (!jumps_->check(system_.scale_of_whole_run(), damping(change), y)) {
      ++summary_.rejected_jumps;
      go_to(*ended - jumped);
      summary_.completed = cycle_;
      return {.time = loads_.begin(cycle_), .state_changed = true, .is_rejected = true};
    }
    result.state_changed = true;
    ++summary_.jumps;
    summary_.longest_jump = std::max(summary_.longest_jump, jumped);
  } else if (jumps_) {
    if (!loads_.repeats(*ended)) jumps_->begin(*ended);
    jumps_->see(*ended, first_, computed);
  }
  CycleRecord record = watch_.record(computed, y, *ended + 1);
  keep_limits(record, *ended, jumped);
  summary_.last_change = last_change(record, *ended);
  result.is_steady =
      summary_.last_change && *summary_.last_change < *config_.time.stop_when_steady && loads_.repeats_from(*ended);
  if (result.is_steady) {
    summary_.steady = *ended + 1;
    log::info("{}", end_message());
  }
  for (std::size_t b = 0; b < record.bodies.size(); ++b)
    if (!watch_.life_of(b).empty()) summary_.to_limit[system_.assembly().bodies()[b].name()] = record.bodies[b].limit;
  previous_ = *ended;
  previous_range_.clear();
  for (const CycleRecord::Probe& probe : record.probes) previous_range_.push_back(probe.range());
  write(*ended, jumped, record, work - work_);
  work_ = work;
  return result;
}

void Cycles::keep_limits(CycleRecord& record, std::int64_t cycle, std::int64_t jumped) {
  for (std::size_t b = 0; b < record.bodies.size(); ++b) {
    CycleRecord::Body& body = record.bodies[b];
    if (std::isfinite(used_up_[b])) {
      body.limit = used_up_[b];
      continue;
    }
    if (body.life.empty() || body.life.back().largest < 1) continue;
    used_up_[b] = body.limit =
        std::clamp(body.limit, static_cast<double>(cycle - jumped), static_cast<double>(cycle + 1));
  }
}

std::optional<double> Cycles::last_change(const CycleRecord& record, std::int64_t cycle) const {
  if (!config_.time.stop_when_steady || previous_ < 0 || !loads_.repeats(cycle)) return std::nullopt;
  const auto n_cycles = static_cast<double>(cycle - previous_);
  double change = record.stress_change;
  for (std::size_t i = 0; i < record.probes.size(); ++i) {
    const CycleRecord::Probe& probe = record.probes[i];
    const double size = std::max(std::abs(probe.min), std::abs(probe.max));
    if (size > 0) change = std::max(change, std::abs(probe.range() - previous_range_[i]) / n_cycles / size);
  }
  return change;
}

void Cycles::write(std::int64_t cycle, std::int64_t jumped, const CycleRecord& record, const RunCounters& work) {
  together(system_.team(), [&] {
    if (!file_) return;
    std::vector<io::CsvCell> row{loads_.end(cycle), cycle + 1,           jumped,
                                 work.steps,        work.elastic_solves, record.stress_change};
    for (const CycleRecord::Body& body : record.bodies) {
      row.emplace_back(body.inelastic_strain_range);
      row.emplace_back(body.strain_range);
      for (const CycleRecord::Life& life : body.life) {
        row.emplace_back(life.largest);
        row.emplace_back(life.per_cycle);
      }
      if (!body.life.empty()) row.emplace_back(body.limit);
    }
    for (const CycleRecord::Probe& probe : record.probes)
      for (const double value : {probe.min, probe.max, probe.end}) row.emplace_back(value);
    file_->write(row);
  });
}

double Cycles::go_back(std::span<double> y) {
  bound_ = cycle_;
  const std::int64_t before = cycle_ - jumps_->jumped();
  jumps_->give_up(y);
  ++summary_.rejected_jumps;
  go_to(before);
  return loads_.begin(before);
}

std::string Cycles::end_message() const {
  if (!summary_.steady) return "";
  return fmt::format("cycle {}, up to t = {:.10g}, repeats the one before it to within {:.3g}: the run ends there",
                     *summary_.steady, loads_.end(*summary_.steady - 1), summary_.steady_within);
}

void Cycles::sync() const {
  if (file_) platform::sync_files(std::array{file_->path()});
}

void Cycles::fill(io::Summary& summary) const {
  summary.cycles = summary_;
}

void Cycles::save(creep::Memory& memory) const {
  memory[cycle_numbers] = {loads_.period(),
                           static_cast<double>(summary_.completed),
                           static_cast<double>(summary_.computed),
                           static_cast<double>(summary_.jumps),
                           static_cast<double>(summary_.rejected_jumps),
                           static_cast<double>(summary_.longest_jump),
                           static_cast<double>(bound_),
                           static_cast<double>(previous_)};
  memory[cycle_limits] = used_up_;
  if (!previous_range_.empty()) memory[cycle_ranges] = previous_range_;
  std::vector<double>& work = memory[cycle_work];
  work.clear();
  for (const RunCounters::Field& field : RunCounters::fields) work.push_back(static_cast<double>(work_.*field.value));
  if (!jumps_ || is_checking()) return;
  ode::CycleExtrapolation::Memory numbers, states;
  jumps_->save(numbers, states);
  for (auto& [name, values] : numbers) memory[extrapolation_prefix + name] = std::move(values);
  for (auto& [name, values] : states) memory[cycle_state_prefix + name] = std::move(values);
}

void Cycles::restore(const creep::Memory& memory) {
  const auto found = memory.find(cycle_numbers);
  if (found == memory.end() || found->second.at(0) != loads_.period()) return;  // a run without cycles, or with others
  const std::vector<double>& numbers = found->second;
  const auto number = [&](std::size_t i) { return static_cast<std::int64_t>(numbers.at(i)); };
  summary_.completed = number(1);
  summary_.computed = number(2);
  summary_.jumps = number(3);
  summary_.rejected_jumps = number(4);
  summary_.longest_jump = number(5);
  bound_ = number(6);
  previous_ = number(7);
  if (const auto ranges = memory.find(cycle_ranges); ranges != memory.end()) previous_range_ = ranges->second;
  if (previous_range_.size() != config_.probes.size()) previous_ = -1;
  if (const auto limits = memory.find(cycle_limits); limits != memory.end()) used_up_ = limits->second;
  const std::vector<double>& work = memory.at(cycle_work);
  for (std::size_t i = 0; i < RunCounters::fields.size(); ++i)
    work_.*RunCounters::fields[i].value = static_cast<std::int64_t>(work.at(i));
  ode::CycleExtrapolation::Memory own, states;
  for (const auto& [name, values] : memory)
    if (name.starts_with(extrapolation_prefix))
      own[name.substr(extrapolation_prefix.size())] = values;
    else if (name.starts_with(cycle_state_prefix))
      states[name.substr(std::string_view(cycle_state_prefix).size())] = values;
  if (jumps_ && !own.empty() && stage_ == Stage::between) jumps_->restore(own, states);
}

}  // namespace creepcontact::run
