#pragma once
/// The path of friction within an accepted step. Friction does not depend on the rate, so between two states only the
/// course of the gaps that the loads open counts. It is followed in substeps that cost contact solves, and no elastic
/// ones. A substep is cut where tractions change much or a node opens, closes, comes to rest or turns back in it, and
/// is checked by halving it where a status changes or the direction of slip turns. The first trial is the step as a
/// whole, of which the solution is known: a step in which nothing happens costs nothing.

#include <functional>
#include <optional>
#include <vector>

#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/creep/equilibrium.hpp"
#include "slip_advance.hpp"

namespace creepcontact::creep {

class FrictionPath {
 public:
  /// The loads after a part of the step, in [0, 1]: weighted gaps without multipliers and without the slip so far.
  using Course = std::function<contact::ContactLoad(double part)>;
  /// @param part  of the step, as for the load
  /// @throws SolverError or contact::UnbalancedLoad if there is no solution
  using Solve = std::function<contact::ContactResult(const contact::ContactLoad& load,
                                                     const contact::ContactState& from, double part)>;

  struct Limits {
    double tolerance = 1e-3;
    double part_of_interval = 1;  ///< that the step is of the time between two breakpoints
    double largest = 1.0 / 8;     ///< size of a substep: its part of the interval, or change of tractions
    double with_event = 1.0 / 32;
    double shortest = 1.0 / 65536;  ///< part of the step
    std::vector<double> ends =
        {};  ///< parts, ascending, in (0, 1): substeps end there, and their first are not trusted
  };

  /// @param problem (with flexibilities), slip  must outlive the object
  FrictionPath(const contact::ContactProblem& problem, const SlipAdvance& slip, const Limits& limits, Course course,
               Solve solve);

  /// The states between two, both included. @param end  solved from the beginning in one step
  /// @returns nothing if a substep has no solution, however short
  std::optional<std::vector<PathPoint>> follow(const PathPoint& begin, const PathPoint& end);

  /// Set after a path without an end, if its last substep has none because nothing balances the loads.
  struct Unbalanced {
    contact::UnbalancedLoad load;
    double time;
  };
  const std::optional<Unbalanced>& unbalanced() const { return unbalanced_; }
  /// Largest error estimate of a substep that could not be shortened any more, relative; 0: none.
  double unresolved() const { return unresolved_; }

 private:
  struct Change;
  struct Sizes;
  struct Onsets;
  std::optional<PathPoint> attempt(const PathPoint& from, double end);
  bool nothing_moves(const PathPoint& begin, const PathPoint& end) const;
  Sizes sizes(const PathPoint& a, const PathPoint& b) const;
  Change change(const PathPoint& from, const PathPoint& to) const;
  double residual(const PathPoint& middle, const PathPoint& end) const;
  double error(const PathPoint& once, const PathPoint& twice) const;
  Onsets onsets(const PathPoint& from, const PathPoint& to) const;
  void add_onsets(const PathPoint& from, PathPoint& to) const;
  /// The error of the dissipated energy of a substep that was halved.
  double energy_error(const PathPoint& from, const PathPoint& middle, const PathPoint& once,
                      const PathPoint& twice) const;
  /// A state with the history that a substep from there leads to.
  PathPoint again(const PathPoint& from, const PathPoint& to) const;
  /// The end of a substep of this size.
  double end_of(double at, double size) const;
  double time(double part) const { return begin_ + part * (end_ - begin_); }

  const SlipAdvance& slip_;
  Limits limits_;
  Course course_;
  Solve solve_;
  Eigen::VectorXd flexibility_;  // per row
  double begin_ = 0, end_ = 1;   // times; of a step across a breakpoint, parts
  double unresolved_ = 0;
  std::optional<Unbalanced> unbalanced_;  // of the last attempt
};

}  // namespace creepcontact::creep
