#pragma once
/// The path of slip within an accepted step: in substeps, along the course of the gaps that the loads open.

#include <functional>
#include <span>
#include <vector>

#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "load_course.hpp"
#include "slip_advance.hpp"

namespace creepcontact::creep {

/// Follows the slip of contacts with friction for an EquilibriumSolver.
class FrictionFollower {
 public:
  /// gap += the gaps that these forces open on the stiffness of the factors. @param forces  per body, n_free
  using AddTraces = std::function<void(std::span<const std::vector<double>> forces, Eigen::VectorXd& gap)>;
  /// The contact problem at time t, in the process that solves it.
  using SolveContact = std::function<contact::ContactResult(const contact::ContactLoad& load,
                                                            const contact::ContactState& from, double t)>;

  /// @param assembly, interface, slip, watch  must outlive the object
  FrictionFollower(const Assembly& assembly, const contact::CondensedInterface& interface, const SlipAdvance& slip,
                   AddTraces add_traces, SolveContact solve_contact, Stopwatch& watch);

  /// The states on the path from the history to an equilibrium that was solved from it, that of the history first: two
  /// if the step is the path; none without friction. Warns once where the path cannot be resolved.
  /// @throws SlidingOff if friction cannot hold a body on the way
  /// Cost: contact solves; some forward substitutions if the loads are not linear in time. Collective.
  std::vector<PathPoint> follow(const Equilibrium& at, const History& history, const PathOptions& options);
  /// See EquilibriumSolver::longest_for_friction().
  double longest_step(double t, double end) const;
  /// Work since construction.
  const RunCounters& counters() const { return counters_; }

 private:
  /// Loads between two times. @param at  the equilibrium at the second one
  /// @param multiplier  the largest at both: the tolerance is relative to it
  LoadCourse load_course(double begin, double end, const Equilibrium& at, double tolerance, double multiplier);
  /// Warns once. @param error  relative to the tolerance
  void warn_of_path(double from, double to, bool has_end, bool is_resolved, double error);

  const Assembly& assembly_;
  const contact::CondensedInterface& interface_;
  const SlipAdvance& slip_;
  AddTraces add_traces_;
  SolveContact solve_contact_;
  Stopwatch& watch_;
  bool stiffness_changes_;
  bool warned_ = false;
  RunCounters counters_;
};

}  // namespace creepcontact::creep
