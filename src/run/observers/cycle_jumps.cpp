#include "cycle_jumps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../checkpoints.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::run {
namespace {

const std::string jumps_name = "cycle_jumps";
const std::string extrapolation_name = jumps_name + ".extrapolation";
const std::string extrapolation_vectors = vectors_like_state + "." + jumps_name;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

CycleJumps::CycleJumps(const RunContext& context)
    : context_(context),
      loads_(context.model.cycles.value()),
      extrapolation_(context.team(), context.config.time.jump_tolerance) {
  if (context.system().has_yielding() && context.team().size() > 1)
    throw ConfigError(
        fmt::format("{}'jump_cycles': plastic strains are extrapolated on one process only; start the program as one "
                    "process, or remove 'jump_cycles'",
                    context.config.time.location.prefix()));
}

std::vector<double> CycleJumps::joined(std::span<const double> y, std::span<const double> flow) {
  std::vector<double> result(y.begin(), y.end());
  result.insert(result.end(), flow.begin(), flow.end());
  return result;
}

void CycleJumps::take(std::span<const double> with_flow, std::span<double> y) {
  std::ranges::copy(with_flow.first(y.size()), y.begin());
  if (with_flow.size() > y.size()) context_.system().set_flow(with_flow.subspan(y.size()));
}

std::int64_t CycleJumps::longest(double t, std::int64_t cycle) const {
  const std::vector<double>& outputs = context_.config.time.output;
  const auto next = std::ranges::upper_bound(outputs, t);
  const double next_output = next != outputs.end() ? *next : infinity;
  // The last cycle is computed: results there are those of a checked state.
  std::int64_t last = std::min(cycle + extrapolation_.proposal(), loads_.ended_by(next_output) - 1);
  if (bound_ >= cycle) last = std::min(last, bound_ - 1);
  for (std::int64_t k = cycle; k <= last; ++k)
    if (!loads_.repeats(k)) last = k - 1;
  return std::max<std::int64_t>(last - cycle, 0);
}

bool CycleJumps::jump(double t, std::int64_t& cycle, std::span<double> y) {
  if (is_checking() || skips_next_) return false;
  const std::int64_t n = longest(t, cycle);
  if (n == 0) return false;
  std::vector<double> all = with_flow(y);
  extrapolation_.jump(n, all);
  take(all, y);
  cycle += n;
  return true;
}

void CycleJumps::begin(std::span<const double> y) {
  skips_next_ = false;
  activity_ = {};
  last_step_.assign(y.begin(), y.end());
  first_flow_ = context_.system().flow();
}

void CycleJumps::step(const StepView& view) {
  if (!is_checking()) return;
  const std::span<const double> y = view.y(), scale = context_.system().scale();
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += std::pow((y[i] - last_step_[i]) / scale[i], 2);
  last_step_.assign(y.begin(), y.end());
  const ode::StepReport& report = view.step->report;
  if (const double change = context_.team().sum(sum); change > activity_.change)
    activity_ = {change, report.time - report.step / 2, last_step_};
}

void CycleJumps::add(std::int64_t cycle, std::span<const double> before, std::span<const double> after) {
  if (!loads_.repeats(cycle)) extrapolation_.begin(cycle);
  extrapolation_.add_cycle(cycle, joined(before, first_flow_), with_flow(after));
}

bool CycleJumps::check(std::span<const double> change, std::span<double> y) {
  const creep::CreepSystem& system = context_.system();
  std::vector<double> all = with_flow(y);
  const bool is_accepted =
      extrapolation_.check(joined(system.scale_of_whole_run(), system.scale_of_flow()), damping(change), all);
  take(all, y);
  return is_accepted;
}

void CycleJumps::give_up(std::int64_t cycle, std::span<double> y) {
  bound_ = cycle;
  std::vector<double> all = with_flow(y);
  extrapolation_.give_up(all);
  take(all, y);
}

ode::CycleExtrapolation::Damping CycleJumps::damping(std::span<const double> change) {
  if (!(activity_.change > 0)) return {};
  std::vector<double> rate(change.size());
  context_.system().begin_segment(-infinity, infinity);
  try {
    context_.system().rate(activity_.time, activity_.state, rate);
  } catch (const RecoverableError&) {
    return {};  // the jump is corrected without
  }
  // The time in which the rate there makes what the cycle does.
  const std::span<const double> scale = context_.system().scale();
  std::array<double, 2> sums{};
  for (std::size_t i = 0; i < change.size(); ++i) {
    const double of_cycle = change[i] / scale[i];
    sums[0] += of_cycle * of_cycle;
    sums[1] += of_cycle * rate[i] / scale[i];
  }
  context_.team().sum(sums);
  const double time = sums[1] * loads_.period() > sums[0] ? sums[0] / sums[1] : loads_.period();
  return [this, time](double weight, std::span<const double> given, std::span<double> damped) {
    const std::size_t n = activity_.state.size();
    context_.system().precondition_once(activity_.time, activity_.state, weight * time, given.first(n),
                                        damped.first(n));
    std::ranges::copy(given.subspan(n), damped.begin() + static_cast<std::ptrdiff_t>(n));
  };
}

void CycleJumps::save(Memory& memory) const {
  memory.save(jumps_name, *this, saved_members);
  if (is_checking()) return;
  Memory numbers, vectors;
  extrapolation_.save(numbers, vectors);
  memory.add(extrapolation_name, std::move(numbers));
  memory.add(extrapolation_vectors, std::move(vectors));
}

void CycleJumps::restore(const Memory& memory) {
  if (memory.part(jumps_name).empty()) return;  // a run without jumps
  memory.restore(jumps_name, *this, saved_members);
  const Memory numbers = memory.part(extrapolation_name);
  if (!numbers.empty()) extrapolation_.restore(numbers, memory.part(extrapolation_vectors));
}

}  // namespace creepcontact::run
