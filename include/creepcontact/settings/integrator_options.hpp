#pragma once
/// Settings of the integrators: the defaults are declared here and nowhere else.

#include <string>

#include "creepcontact/settings/enum_names.hpp"

namespace creepcontact::settings {

enum class StepMode {
  fixed,
  stable,
  adaptive,
  to_limit  ///< every step goes to the limit given: the caller decides; the configuration has no name for it
};
constexpr auto names_of(StepMode) {
  return std::to_array<EnumName<StepMode>>({{"stable", StepMode::stable}, {"adaptive", StepMode::adaptive}});
}

/// How long the steps of the Euler schemes are.
struct StepChoice {
  StepMode mode = StepMode::stable;
  double length = 0;  ///< fixed

  StepChoice() = default;
  // A mode or a length is a choice.
  StepChoice(StepMode how) : mode(how) {}                             // NOLINT(google-explicit-constructor)
  StepChoice(double fixed) : mode(StepMode::fixed), length(fixed) {}  // NOLINT(google-explicit-constructor)
};

/// How beta_euler solves for the new state.
enum class InnerIteration { fixed_point, newton };
constexpr auto names_of(InnerIteration) {
  return std::to_array<EnumName<InnerIteration>>(
      {{"fixed_point", InnerIteration::fixed_point}, {"newton", InnerIteration::newton}});
}

/// How implicit methods solve their Newton systems: GMRES with JacobianProducts, or NewtonSolver.
enum class LinearSolver { krylov, tangent };
constexpr auto names_of(LinearSolver) {
  return std::to_array<EnumName<LinearSolver>>({{"krylov", LinearSolver::krylov}, {"tangent", LinearSolver::tangent}});
}

/// Settings of all integrators; each uses those that concern it.
struct IntegratorOptions {
  double tolerance = 1e-4;             ///< relative accuracy; absolute tolerance = tolerance * System::scale()
  StepChoice step = StepMode::stable;  ///< Euler: fixed, the stable step times step_factor, or under error control
  double step_factor = 1.0;
  double beta = 1.0;  ///< beta_euler, >= 0.5
  InnerIteration inner = InnerIteration::fixed_point;
  double inner_tolerance = 1e-10;    ///< beta_euler: bound on the last change of the creep strain by inner iterations
  int max_inner_iterations = 200;    ///< beta_euler
  int inner_anderson = 0;            ///< beta_euler: depth of Anderson acceleration of the inner iterations; 0: plain
  double residual_correction = 1.0;  ///< beta_euler: gamma, fraction of the force residual that the next step corrects
  LinearSolver linear_solver = LinearSolver::krylov;  ///< cvode_bdf, arkode_dirk
  std::string table = {};     ///< ARKODE: name of a Butcher table with an embedded method; empty: the default
  double end_time = 0;        ///< end of the run, bounds the first step
  int restart_interval = 20;  ///< ARKODE: steps from one restart point to the next
};

}  // namespace creepcontact::settings
