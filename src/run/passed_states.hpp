#pragma once
/// States between output times, which observers look at for extremes.

#include "creepcontact/run/step_view.hpp"

namespace creepcontact::run {

/// Evaluates them where this costs little: steps have made most of these evaluations.
class PassedStates {
 public:
  /// @param costs_solves  nothing else needs these states: only the first ones are evaluated
  explicit PassedStates(bool costs_solves) : costs_solves_(costs_solves) {}

  /// @returns false if the state is not looked at: there is no equilibrium, or there have been too many. A warning says
  /// so where nothing else does. Collective.
  bool evaluate(StepView& view);

 private:
  bool costs_solves_;
  int n_solved_ = 0;
};

}  // namespace creepcontact::run
