#pragma once
/// The coarse problem of bodies held by contact alone, on one set of rows: N^T lambda + resultant = 0 there, and the
/// rigid-body modes that a mismatch of the traces contains. A set may hold only some of the modes.

#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// N^T multiplier + resultant. @param resultant  empty: zero
Eigen::VectorXd unbalanced(const Eigen::MatrixXd& rigid, const Eigen::VectorXd& multiplier,
                           const Eigen::VectorXd& resultant);
/// Whether that is at most this part of the forces that make it up, or rounding. @param rounding  of the multipliers
bool is_balanced(const Eigen::MatrixXd& rigid, const Eigen::VectorXd& multiplier, const Eigen::VectorXd& resultant,
                 double part, double rounding);

class RigidBalance {
 public:
  RigidBalance() = default;
  RigidBalance(const ContactProblem& problem, const std::vector<int>& rows);

  /// Orthonormal basis of the gaps that the motions open, n_rows x rank.
  const Eigen::MatrixXd& basis() const { return basis_; }
  bool empty() const { return basis_.cols() == 0; }

  /// N^T lambda + resultant. @param multiplier  on the rows
  Eigen::VectorXd unbalanced(const Eigen::VectorXd& multiplier, const Eigen::VectorXd& resultant) const;
  /// N (N^T N)^+ of unbalanced resultants: the least multipliers that carry them.
  Eigen::VectorXd carrying(const Eigen::VectorXd& unbalanced) const;
  /// Amplitudes alpha that take the rigid part out of a mismatch: N alpha + mismatch is orthogonal to all motions.
  Eigen::VectorXd amplitudes(const Eigen::VectorXd& mismatch) const;
  /// mismatch + N alpha
  Eigen::VectorXd without_rigid_part(const Eigen::VectorXd& mismatch) const;
  /// Whether multipliers balance the resultants but for rounding. @param rounding  of the multipliers
  bool holds(const Eigen::VectorXd& multiplier, const Eigen::VectorXd& resultant, double rounding) const;

 private:
  Eigen::MatrixXd rigid_, basis_;  // N; N = basis diag(values) motions^T
  double largest_resultant_ = 0;   // resultant of unit multipliers on all rows of the problem
  Eigen::VectorXd values_;
  Eigen::MatrixXd motions_;
};

/// Orthonormal basis of the columns' span, singular values and right vectors; those below 1e-6 of the largest are none.
void singular_parts(const Eigen::MatrixXd& matrix, Eigen::MatrixXd& left, Eigen::VectorXd& values,
                    Eigen::MatrixXd& right);

}  // namespace creepcontact::contact
