#include "rigid_balance.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::contact {
namespace {

constexpr double weakest_hold = 1e-6;   // of the best held motion: below it a motion is free
constexpr double balance_error = 1e-9;  // of the forces that make up a resultant

}  // namespace

void singular_parts(const Eigen::MatrixXd& matrix, Eigen::MatrixXd& left, Eigen::VectorXd& values,
                    Eigen::MatrixXd& right) {
  const linalg::SingularValues svd = linalg::singular_values(matrix);
  Index rank = 0;
  while (rank < svd.values.size() && svd.values[rank] > weakest_hold * svd.values[0]) ++rank;
  left = svd.left.leftCols(rank);
  values = svd.values.head(rank);
  right = svd.right.leftCols(rank);
}

RigidBalance::RigidBalance(const ContactProblem& problem, const std::vector<int>& rows)
    : rigid_(problem.n_motions() > 0 ? Eigen::MatrixXd(problem.rigid(rows, Eigen::all))
                                     : Eigen::MatrixXd(rows.size(), 0)),
      largest_resultant_(problem.n_motions() > 0 ? problem.rigid.cwiseAbs().colwise().sum().maxCoeff() : 0.0) {
  singular_parts(rigid_, basis_, values_, motions_);
}

Eigen::VectorXd unbalanced(const Eigen::MatrixXd& rigid, const Eigen::VectorXd& multiplier,
                           const Eigen::VectorXd& resultant) {
  Eigen::VectorXd sum = rigid.transpose() * multiplier;
  if (resultant.size() > 0) sum += resultant;
  return sum;
}

bool is_balanced(const Eigen::MatrixXd& rigid, const Eigen::VectorXd& multiplier, const Eigen::VectorXd& resultant,
                 double part, double rounding) {
  if (rigid.cols() == 0) return true;
  const double largest = resultant.size() > 0 ? resultant.cwiseAbs().maxCoeff() : 0.0;
  const double sum = (rigid.cwiseAbs().transpose() * multiplier.cwiseAbs()).maxCoeff();
  return unbalanced(rigid, multiplier, resultant).cwiseAbs().maxCoeff() <=
         std::max(part * std::max(largest, sum), rounding * rigid.cwiseAbs().colwise().sum().maxCoeff());
}

Eigen::VectorXd RigidBalance::unbalanced(const Eigen::VectorXd& multiplier, const Eigen::VectorXd& resultant) const {
  return contact::unbalanced(rigid_, multiplier, resultant);
}

Eigen::VectorXd RigidBalance::carrying(const Eigen::VectorXd& unbalanced) const {
  return basis_ * (motions_.transpose() * unbalanced).cwiseQuotient(values_);
}

Eigen::VectorXd RigidBalance::amplitudes(const Eigen::VectorXd& mismatch) const {
  return -motions_ * (basis_.transpose() * mismatch).cwiseQuotient(values_);
}

Eigen::VectorXd RigidBalance::without_rigid_part(const Eigen::VectorXd& mismatch) const {
  return mismatch - basis_ * (basis_.transpose() * mismatch);
}

bool RigidBalance::holds(const Eigen::VectorXd& multiplier, const Eigen::VectorXd& resultant, double rounding) const {
  // Loads that round-off alone leaves may be balanced by nothing on these rows.
  return is_balanced(rigid_, multiplier, resultant, balance_error, rounding) ||
         unbalanced(multiplier, resultant).cwiseAbs().maxCoeff() <= rounding * largest_resultant_;
}

}  // namespace creepcontact::contact
