#include "cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

const std::string cycles_name = "cycles";
constexpr double min_life = 0.01;  // that a whole run uses up: smaller ones need no accuracy of their own

/// What of the counts a resumed run goes on from.
constexpr auto saved_counts = [] {
  using Counts = io::Summary::Cycles;
  return std::tuple{Member{"completed", &Counts::completed}, Member{"computed", &Counts::computed},
                    Member{"jumps", &Counts::jumps}, Member{"rejected_jumps", &Counts::rejected_jumps},
                    Member{"longest_jump", &Counts::longest_jump}};
}();

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

Cycles::Cycles(const RunContext& context)
    : context_(context),
      loads_(context.model.cycles.value()),
      watch_(context.system()),
      closed_(context.assembly().bodies().size()) {
  const config::Config& config = context.config;
  summary_.steady_within = config.time.stop_when_steady.value_or(0);
  if (config.time.jump_cycles && context.integrates) jumps_.emplace(context);
  go_to(loads_.ended_by(context.begin));
  if (context.begin > 0 && !loads_.ending_at(context.begin)) stage_ = Stage::waiting;
  if (context.resumed != nullptr && stage_ == Stage::waiting && loads_.ended_by(context.begin) < loads_.count())
    log::warning(
        "the run is resumed at t = {:.10g}, within cycle {}: what this cycle does up to there is not known, so it has "
        "no row in cycles.csv and does not count for fatigue",
        context.begin, loads_.ended_by(context.begin) + 1);
  together(context.team(), [&] {
    if (!context.observed.is_root() || context.directory.empty()) return;
    const std::filesystem::path path = context.directory / "cycles.csv";
    file_ = std::make_unique<io::CsvFile>(
        path, cycle_columns(context.assembly(), watch_, config.probes),
        io::Continuation{.resume = context.resumed != nullptr && path_exists(path), .last_time = context.begin},
        config.output.csv);
  });
}

void Cycles::go_to(std::int64_t cycle) {
  cycle_ = cycle;
  stage_ = cycle < loads_.count() ? Stage::between : Stage::waiting;
}

Reaction Cycles::begin(StepView& view) {
  if (stage_ != Stage::between) return Reaction::advance;
  if (jumps_) {
    RunState state{.y = {view.y().begin(), view.y().end()}};
    if (jumps_->jump(view.time(), cycle_, state.y)) {
      state.time = std::max(view.time(), loads_.begin(cycle_));
      changed_ = std::move(state);
      return Reaction::restart;
    }
    jumps_->begin(view.y());
  }
  try {
    watch_.begin(view);
  } catch (const RecoverableError&) {  // the state after the jump has no equilibrium
    if (!may_go_back()) throw;
    jumps_->skip_next();
    return Reaction::go_back;
  }
  stage_ = Stage::within;
  return Reaction::advance;
}

Reaction Cycles::step(StepView& view) {
  if (jumps_) jumps_->step(view);
  return Reaction::advance;
}

void Cycles::jump(StepView& view) {
  if (stage_ == Stage::within && loads_.jumps_at(view.time())) watch_.observe(view);
}

void Cycles::state(StepView& view) {
  if (stage_ == Stage::within) watch_.observe_probes(view.probe_values());
}

void Cycles::output(StepView& view) {
  if (stage_ == Stage::within) watch_.observe_probes(view.probe_values());
}

Reaction Cycles::segment(StepView& view) {
  if (stage_ == Stage::within) watch_.observe(view);
  const std::optional<std::int64_t> ended = loads_.ending_at(view.time());
  if (!ended) return Reaction::advance;
  if (stage_ == Stage::within) return close(*ended, view);
  go_to(*ended + 1);
  summary_.completed = cycle_;
  if (jumps_) jumps_->forget(cycle_);
  closed_.forget_last();
  return Reaction::advance;
}

Reaction Cycles::close(std::int64_t cycle, StepView& view) {
  creep::CreepSystem& system = context_.system();
  go_to(cycle + 1);
  summary_.completed = cycle_;
  RunState state{.time = view.time(), .y = {view.y().begin(), view.y().end()}};
  bool is_changed = watch_.add_cycle(state.y);
  const std::vector<double> computed = state.y;
  const std::int64_t jumped = may_go_back() ? jumps_->jumped() : 0;
  ++summary_.computed;
  std::vector<double> change = computed;
  for (std::size_t i = 0; i < change.size(); ++i) change[i] -= watch_.first()[i];
  system.resolve_cycle(change, min_life / static_cast<double>(loads_.count()));
  if (jumped > 0) {
    if (!jumps_->check(change, state.y)) {
      ++summary_.rejected_jumps;
      go_to(cycle - jumped);
      summary_.completed = cycle_;
      state.time = loads_.begin(cycle_);
      changed_ = std::move(state);
      return Reaction::go_back;
    }
    is_changed = true;
    ++summary_.jumps;
    summary_.longest_jump = std::max(summary_.longest_jump, jumped);
  } else if (jumps_) {
    jumps_->add(cycle, watch_.first(), computed);
  }
  CycleRecord record = watch_.record(computed, state.y, cycle + 1);
  closed_.keep_used_lives(record, cycle, jumped);
  summary_.last_change.reset();
  if (context_.config.time.stop_when_steady && loads_.repeats(cycle))
    summary_.last_change = closed_.change(record, cycle);
  if (summary_.last_change && *summary_.last_change < *context_.config.time.stop_when_steady &&
      loads_.repeats_from(cycle)) {
    summary_.steady = cycle + 1;
    log::info("{}", end_message());
  }
  for (std::size_t b = 0; b < record.bodies.size(); ++b)
    if (!watch_.life_of(b).empty()) summary_.to_limit[context_.assembly().bodies()[b].name()] = record.bodies[b].limit;
  closed_.add(record, cycle);
  write(cycle, jumped, record, view.work() - work_);
  work_ = view.work();
  if (is_changed) changed_ = std::move(state);
  if (summary_.steady) return Reaction::stop;
  return is_changed ? Reaction::restart : Reaction::advance;
}

void Cycles::change(RunState& state) {
  if (changed_) {
    state.time = changed_->time;
    state.y = std::move(changed_->y);
    changed_.reset();
  } else if (may_go_back()) {  // something must not be skipped: an event, rupture, a step that fails
    const std::int64_t before = cycle_ - jumps_->jumped();
    jumps_->give_up(cycle_, state.y);
    ++summary_.rejected_jumps;
    go_to(before);
    state.time = loads_.begin(before);
  }
}

void Cycles::write(std::int64_t cycle, std::int64_t jumped, const CycleRecord& record, const RunCounters& work) {
  together(context_.team(), [&] {
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

std::string Cycles::end_message() const {
  if (!summary_.steady) return "";
  return fmt::format("cycle {}, up to t = {:.10g}, repeats the one before it to within {:.3g}: the run ends there",
                     *summary_.steady, loads_.end(*summary_.steady - 1), summary_.steady_within);
}

void Cycles::sync() {
  if (file_) platform::sync_files(std::array{file_->path()});
}

void Cycles::finish(Summary& summary) const {
  summary.results.cycles = summary_;
  if (summary.results.status == io::Summary::Status::completed) summary.results.message = end_message();
}

void Cycles::save(creep::Memory& memory) const {
  memory.save(cycles_name + ".period", loads_.period());
  memory.save(cycles_name, *this, saved_members);
  memory.save(cycles_name, summary_, saved_counts);
  closed_.save(memory);
  if (jumps_) jumps_->save(memory);
}

void Cycles::restore(const creep::Memory& memory) {
  const auto period = memory.find(cycles_name + ".period");
  if (period == memory.end() || period->second.at(0) != loads_.period())
    return;  // a run without cycles, or with others
  memory.restore(cycles_name, *this, saved_members);
  memory.restore(cycles_name, summary_, saved_counts);
  closed_.restore(memory, context_.config.probes.size());
  if (jumps_ && stage_ == Stage::between) jumps_->restore(memory);
}

std::unique_ptr<Observer> observe_cycles(const RunContext& context) {
  if (!context.model.cycles) return nullptr;
  return std::make_unique<Cycles>(context);
}

}  // namespace creepcontact::run
