#pragma once
/// How slip goes on from one state of contact to the next: what it counts from, and what a substep adds to it.

#include <cstddef>
#include <span>
#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/contact/solver/problem.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// A contact node with friction.
struct SlipNode {
  std::size_t number = 0;  ///< among all nodes of the problem
  std::size_t pair = 0;
  Index normal_row = 0;
  Index first = 0, n = 0;  ///< tangential rows
  double area = 0;

  auto tangential(const Eigen::VectorXd& of_rows) const { return of_rows.segment(first, n); }
  auto tangential(Eigen::VectorXd& of_rows) const { return of_rows.segment(first, n); }
  const contact::NodeLinearization& at(const contact::ContactState& state) const { return state.nodes[number]; }
};

/// Relative to the time: steps this short lead across a breakpoint, and have no rates.
inline constexpr double min_relative_step = 1e-9;

/// Pure functions of their arguments; without flexibilities, so that every process can call them.
class SlipAdvance {
 public:
  /// @param problem, pairs (numbered)  must outlive the object
  SlipAdvance(const contact::ContactProblem& problem, std::span<const contact::Pair> pairs);

  std::span<const SlipNode> nodes() const { return nodes_; }

  /// What the slip of a state at time t counts from, per row (zero in normal rows): the slip so far; at a node that is
  /// open and closes, the one that it reaches when the gap, going on to close at its rate, is closed.
  Eigen::VectorXd reference(const PathPoint& from, double t) const;

  /// The history at time t. @param gaps  of the solution `to`; in tangential rows from the reference on
  /// @param reference  reference(from, t)
  SlipHistory advanced(const PathPoint& from, double t, const Eigen::VectorXd& reference,
                       const contact::ContactState& to, const Eigen::VectorXd& gaps) const;

 private:
  void add_rates(const PathPoint& from, double duration, const contact::ContactState& to, SlipHistory& next) const;

  std::size_t n_rows_;
  std::vector<SlipNode> nodes_;
};

}  // namespace creepcontact::creep
