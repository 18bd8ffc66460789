#include "creepcontact/contact/frozen_system.hpp"

#include "creepcontact/base/error.hpp"

namespace creepcontact::contact {

bool factor_semidefinite(const Eigen::MatrixXd& matrix, Eigen::LLT<Eigen::MatrixXd>& factor) {
  factor.compute(matrix);
  if (factor.info() == Eigen::Success && factor.rcond() > 1e-13) return true;
  Eigen::MatrixXd shifted = matrix;
  shifted.diagonal().array() += 1e-12 * matrix.diagonal().maxCoeff();
  factor.compute(shifted);
  return factor.info() == Eigen::Success;
}

Eigen::VectorXd FrozenSystem::solve(const std::vector<int>& active, const Eigen::VectorXd& gap) {
  Eigen::VectorXd multiplier = Eigen::VectorXd::Zero(problem_.n_rows());
  if (active.empty()) return multiplier;
  if (active != active_) {
    active_.clear();
    if (!factor_semidefinite(problem_.total(active, active), factor_))
      throw SolverError("contact: the conditions of the active set contradict each other");
    active_ = active;
  }
  const Eigen::VectorXd right_hand_side = -gap(active);
  const Eigen::VectorXd solution = factor_.solve(right_hand_side);
  multiplier(active) = solution;
  return multiplier;
}

}  // namespace creepcontact::contact
