#pragma once
/// What lies within the last accepted step, with friction or plastic flow: states on the path that they have taken.

#include <utility>
#include <vector>

#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::creep {

/// The path of the last accepted step, from which results within it are found. Values; empty before the first step and
/// where nothing depends on the path.
class LastPath {
 public:
  LastPath() = default;
  /// @param legs  EquilibriumSolver::accept()
  explicit LastPath(std::vector<PathLeg> legs) : legs_(std::move(legs)) {}

  /// True for times before the end.
  bool contains(double t) const { return !legs_.empty() && t < legs_.back().end; }
  /// True if the state at the end is not the one that the step was accepted with.
  bool has_substeps() const { return legs_.size() > 1 || (!legs_.empty() && legs_.front().points.size() > 2); }
  /// Equilibrium at a time within the step, solved from the last state on the path before it. Accumulated slip and
  /// dissipated energy are between those of the states around it. Precondition: contains(t).
  /// @throws as EquilibriumSolver::solve()
  void solve(EquilibriumSolver& solver, double t, EquilibriumSolver::CreepStrains creep, Equilibrium& into) const;

 private:
  std::vector<PathLeg> legs_;
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
