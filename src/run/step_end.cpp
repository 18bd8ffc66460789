#include "step_end.hpp"

#include <algorithm>
#include <limits>

namespace creepcontact::run {
namespace {
constexpr double max_stretch = 1.1;  // of the step that an integrator proposes
}

StepEnd::StepEnd(const config::Config& config, const model::Model& model, creep::CreepSystem& system, bool integrates)
    : config_(config), model_(model), system_(system) {
  if (integrates) guard_.emplace(config, model, system);
}

StepEnd::Limit StepEnd::next(const ode::Integrator& integrator, const Schedule& schedule) {
  const double t = integrator.time();
  const bool may_pass_outputs = integrator.interpolates() && !config_.time.stop_at_output;
  const double stop = schedule.next_stop();
  const double limit =
      std::min(may_pass_outputs ? stop : std::min(stop, schedule.next_output()), longest(t, integrator.state()));
  if (!guard_) return {.time = limit};
  const double proposed = integrator.next_step();
  const bool is_proposed = proposed > 0;
  const double reach = is_proposed ? std::min(limit, t + max_stretch * proposed) : limit;
  const auto [begin, end] = schedule.segment(t);
  const auto found = guard_->end_of_step(t, integrator.state(), reach, is_proposed,
                                         {creep::just_after(begin), creep::just_before(end)});
  return found ? Limit{.time = found->time, .is_jump = found->is_jump} : Limit{.time = limit};
}

double StepEnd::longest(double t, std::span<const double> y) const {
  if (config_.time.step.mode == settings::StepMode::fixed) return std::numeric_limits<double>::infinity();
  const double of_loads = model_.step_limits.latest_end(t);
  return guard_ || system_.has_yielding() ? std::min(of_loads, t + system_.longest_step(t, y)) : of_loads;
}

void StepEnd::save(creep::Memory& memory) const {
  if (guard_) guard_->save(memory);
}

void StepEnd::restore(const creep::Memory& memory) {
  if (guard_) guard_->restore(memory);
}

}  // namespace creepcontact::run
