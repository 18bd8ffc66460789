#pragma once
/// Contact with friction by the solvers of contact without friction: the tractions of slipping nodes are frozen
/// (Tresca's law), and iterated.

#include "friction_newton.hpp"
#include "set_solver.hpp"

namespace creepcontact::contact {

/// With the tractions of slipping nodes given, the rows of closed nodes (normal) and of sticking ones (tangential) form
/// an active set, solved by sweeps or conjugate gradients (SetSolver): tangential tractions are exchanged between the
/// bodies like pressures. Pressures and slip then give new tractions: first those of slipping nodes under frozen
/// limits, then limits from the new pressures. Aitken's method accelerates this iteration, which converges linearly
/// where friction_kappa() is below 1.
class Tresca {
 public:
  /// @param problem  must outlive the object
  Tresca(const ContactProblem& problem, const SchwarzOptions& options)
      : problem_(problem), options_(options), sets_(problem, inner(options)) {}

  void flexibility_changed();
  SetSolver& sets() { return sets_; }
  const SetSolver& sets() const { return sets_; }
  /// Solves from state.multiplier and state.nodes. @param rows  of the problem
  /// @returns false if the iteration does not converge, or contact cannot balance the loads; the state is then
  /// unchanged
  bool solve(const ContactLoad& load, double rounding, const FrictionRows& rows, FrictionState& state,
             ContactResult& total);

 private:
  class Iteration;
  /// Errors of the inner iterations must not be seen by the outer one.
  static SchwarzOptions inner(SchwarzOptions options) {
    options.tolerance *= 0.01;
    return options;
  }

  const ContactProblem& problem_;
  SchwarzOptions options_;
  SetSolver sets_;
  double scale_ = 0;  // steps of the tractions are scale / diag F times the slip: the longest that converge; 0: not set
};

}  // namespace creepcontact::contact
