#include "guarded_steps.hpp"

#include <algorithm>

#include "creepcontact/base/log.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::run {
namespace {

constexpr double allowed_effect = 0.05;  // of the error that a step may make
constexpr double max_age = 20;           // findings for which a known effect counts
constexpr double larger = 1.5;           // deviation over the known one, beyond which the effect is computed again
constexpr const char* memory_name = "guard.effects";

}  // namespace

GuardedSteps::GuardedSteps(const config::Config& config, const model::Model& model, creep::CreepSystem& system)
    : system_(system),
      guard_(model::courses_in_time(config, model), config.time.end, config.time.tolerance),
      is_fixed_(config.time.step.mode == settings::StepMode::fixed),
      effects_(guard_.courses().size()),
      reported_(guard_.courses().size(), 0) {}

std::optional<GuardedSteps::End> GuardedSteps::end_of_step(double t, std::span<const double> y, double to,
                                                           bool is_proposed, const model::StepGuard::Segment& segment) {
  std::optional<End> end;
  for (std::size_t i = 0; i < guard_.courses().size(); ++i) {
    const auto found = guard_.examine(i, t, end ? end->time : to, segment);
    if (!found) continue;
    const bool matters_here = found->is_jump || (is_proposed && matters(*found, t, y, to - t));
    if (matters_here) report(*found, t, to);
    if (is_fixed_ ? !found->is_jump : is_proposed && !matters_here) continue;
    end = {.time = found->time, .is_jump = found->is_jump};
  }
  return end;
}

bool GuardedSteps::matters(const model::StepGuard::Finding& finding, double t, std::span<const double> y,
                           double length) {
  Effect& effect = effects_[finding.course];
  ++effect.age;
  if (effect.largest == 0 || effect.age > max_age || finding.relative > larger * effect.largest)
    effect = {.per_deviation = system_.rate_change(t, y, finding.at) / finding.relative,
              .largest = finding.relative,
              .age = 0};
  return effect.per_deviation * finding.relative * finding.share * length > allowed_effect;
}

void GuardedSteps::report(const model::StepGuard::Finding& finding, double t, double to) {
  if (reported_[finding.course] != 0) return;
  reported_[finding.course] = 1;
  const std::string& key = guard_.courses()[finding.course].key;
  if (is_fixed_ && !finding.is_jump)
    log::warning(
        "{}: within the step from t = {:.6g} to {:.6g} it deviates by {:.3g} from what the ends of the step show, at t "
        "= {:.6g}; steps of a fixed length do not follow it: use a shorter time.step, or an integrator with error "
        "control",
        key, t, to, finding.deviation, finding.at);
  else if (finding.is_jump)
    log::warning(
        "{}: it jumps at t = {:.10g}, which was not found before the run; the step ends there. Others like it that are "
        "shorter than the steps may be missed: list the times of jumps in time.breakpoints",
        key, finding.time);
  else
    log::info("{}: steps are shortened from t = {:.6g} on, to follow its course", key, t);
}

void GuardedSteps::save(creep::Memory& memory) const {
  if (guard_.is_needed()) memory.save(memory_name, effects_);
}

void GuardedSteps::restore(const creep::Memory& memory) {
  if (!memory.contains(std::string(memory_name) + ".age")) return;
  std::vector<Effect> effects;
  memory.restore(memory_name, effects);
  if (effects.size() == effects_.size()) effects_ = std::move(effects);  // a run that is prolonged may have others
}

}  // namespace creepcontact::run
