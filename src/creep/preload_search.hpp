#pragma once
/// Interferences that give contacts prescribed normal forces. Without friction the forces are the gradient of a convex,
/// piecewise quadratic function of the interferences, and Newton's method with a line search finds them from anywhere.
/// Where bodies yield the elastic stiffness is too large, and Broyden's update corrects it from step to step (C. G.
/// Broyden, Math. Comput. 19 (1965) 577); of one preload this is the secant.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::creep {

struct PreloadSearch {
  std::vector<std::string> names;  ///< of the n preloaded contacts, for messages
  Eigen::VectorXd forces;          ///< n, to be reached
  Eigen::MatrixXd gaps;            ///< n_rows x n: change of the weighted gaps per unit of each interference
  /// Contact state for these interferences.
  std::function<const contact::ContactState&(const Eigen::VectorXd& interference)> solve;
  /// Change of the multipliers for a change of the gaps, with the closed rows of a state held closed.
  std::function<Eigen::VectorXd(const contact::ContactState& at, const Eigen::VectorXd& gap)> change;
  /// The state with all movable rows of all contacts closed: the stiffest answer to an interference.
  std::function<contact::ContactState(const contact::ContactState& at)> closed;
  double time = 0;           ///< for messages
  double part = 1;           ///< of the preloads, that `forces` are; for messages
  bool is_yielding = false;  ///< `change` is elastic, but `solve` may yield
  double tolerance = 1e-9;   ///< of the forces

  /// @param interference  n, to start from @returns n interferences; `solve` was called with them last
  /// @throws ModelError naming the contact and its largest force if a force cannot be reached
  Eigen::VectorXd find(Eigen::VectorXd interference) const;
};

}  // namespace creepcontact::creep
