#pragma once
/// What lies within the last accepted step, with friction: states on the path that slip has taken.

#include <vector>

#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::creep {

/// The path of the last accepted step, from which results within it are found. Values; empty before the first step.
class LastPath {
 public:
  LastPath() = default;
  /// @param before  the history of the step before @param points  EquilibriumSolver::accept()
  LastPath(History before, std::vector<PathPoint> points);

  /// True if the state at the end is not the one that the step was accepted with.
  bool has_substeps() const { return points_.size() > 2; }
  /// Equilibrium at a time within the step, solved from the last state on the path before it. Accumulated slip and
  /// dissipated energy are between those of the states around it. Precondition: not empty.
  /// @throws as EquilibriumSolver::solve()
  void solve(EquilibriumSolver& solver, double t, EquilibriumSolver::CreepStrains creep, Equilibrium& into) const;

 private:
  History before_;
  std::vector<PathPoint> points_;
};

/// Accumulated slip and dissipated energy of the last result: those of later ones are not below.
class ReportedSlip {
 public:
  /// Raises what is below the last result, and takes this for the last one. A result of an earlier time begins again.
  void raise(SlipHistory& friction);

 private:
  SlipHistory last_;
};

}  // namespace creepcontact::creep
