/// Damage, used-up life, and the end of a run by rupture.
#include "creepcontact/base/log.hpp"
#include "creepcontact/results/damage_monitor.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

/// Damage at which steps that shrink to nothing mean rupture: the rate of damage is then infinite.
constexpr double almost_ruptured = 0.5;
constexpr double min_relative_step = 1e-9;         // of the time: a step that has shrunk to nothing
constexpr double rupture_damage_on_failure = 0.9;  // from here on a step that cannot be made means rupture
constexpr int steps_between_warnings = 50;

class LifeObserver final : public Observer {
 public:
  explicit LifeObserver(const RunContext& context) : context_(context), monitor_(context.system()) {}

  Reaction step(StepView& view) override {
    if (++n_steps_ % steps_between_warnings == 0) monitor_.warn(view.time(), near(view), view.y());
    const double damage = largest(view).value;
    if (damage < almost_ruptured) return Reaction::advance;
    if (view.is_tentative) return Reaction::go_back;
    if (!(view.step->report.step < min_relative_step * view.time())) return Reaction::advance;
    rupture(view);
    return Reaction::stop;
  }
  /// Right before rupture steps may have become as short as numbers allow.
  Reaction failure(StepView& view) override {
    if (largest(view).value < rupture_damage_on_failure) return Reaction::advance;
    rupture(view);
    return Reaction::stop;
  }
  void output(StepView& view) override {
    monitor_.output(view.evaluation());
    monitor_.warn(view.time(), view.evaluation(), view.evaluation().y);
  }

  std::vector<std::size_t> conditions(StepView& view) const override {
    return holds(0, view) ? std::vector<std::size_t>{0} : std::vector<std::size_t>{};
  }
  bool holds(std::size_t /*number*/, StepView& view) const override {
    return monitor_.has_damage() && monitor_.is_rupture(largest(view), view.time(), near(view), view.y());
  }
  void happened(std::size_t /*number*/, StepView& view) override { rupture(view); }
  bool stops(std::size_t /*number*/) const override { return true; }
  /// Damage is part of the state: evaluations cost nothing.
  double resolution() const override { return 0x1p-50; }

  void finish(Summary& summary) const override { monitor_.fill(summary.results); }

 private:
  /// An evaluation of the state or of one close to it: damage is part of the state.
  const creep::Evaluation& near(StepView& view) const {
    const creep::Evaluation& of_step = context_.system().step_evaluation();
    return of_step.valid ? of_step : view.evaluation();
  }
  creep::CreepSystem::Extreme largest(StepView& view) const {
    return monitor_.has_damage() ? monitor_.largest_damage(near(view), view.y()) : creep::CreepSystem::Extreme{};
  }
  void rupture(StepView& view) {
    const creep::CreepSystem::Extreme where = largest(view);
    monitor_.rupture(view.time(), where);
    log::info("body '{}' ruptures at t = {:.6g}: damage {:.3g} at ({:.6g}, {:.6g}, {:.6g})",
              context_.model.bodies()[where.body].name(), view.time(), where.value, where.position.x(),
              where.position.y(), where.position.z());
  }

  const RunContext& context_;
  results::DamageMonitor monitor_;
  int n_steps_ = 0;
};

}  // namespace

std::unique_ptr<Observer> observe_life(const RunContext& context) {
  return std::make_unique<LifeObserver>(context);
}

}  // namespace creepcontact::run
