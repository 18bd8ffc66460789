#pragma once
/// Where the next step of a run has to end at the latest.

#include <optional>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "guarded_steps.hpp"
#include "schedule.hpp"

namespace creepcontact::run {

/// Breakpoints, output times of integrators that do not interpolate, yielding, friction, vibrations, and what the steps
/// would not see of the functions.
class StepEnd {
 public:
  /// @param config, model, system  must outlive the object @param integrates  the integrator has a state
  StepEnd(const config::Config& config, const model::Model& model, creep::CreepSystem& system, bool integrates);

  struct Limit {
    double time = 0;
    bool is_jump = false;  ///< of a function, not known before: a breakpoint
  };
  /// The limit of the step from the state of the integrator. Collective. Cost: see GuardedSteps::end_of_step()
  Limit next(const ode::Integrator& integrator, const Schedule& schedule);

  void save(creep::Memory& memory) const;
  void restore(const creep::Memory& memory);

 private:
  double longest(double t, std::span<const double> y) const;

  const config::Config& config_;
  const model::Model& model_;
  creep::CreepSystem& system_;
  std::optional<GuardedSteps> guard_;  // of integrators with a state
};

}  // namespace creepcontact::run
