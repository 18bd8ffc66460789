#pragma once
/// The linear equations F_II lambda_I = -gap_I of a frozen active set I, factored once a set.

#include <vector>

#include "creepcontact/contact/problem.hpp"

namespace creepcontact::contact {

class FrozenSystem {
 public:
  explicit FrozenSystem(const ContactProblem& problem) : problem_(problem) {}

  /// Multipliers (n_rows, zero off the set) that close the gaps of the set.
  /// Cost: two triangular solves of the set's size; a Cholesky factorisation when the set is another than last time.
  /// @throws SolverError if the contact conditions of the set contradict or repeat each other
  Eigen::VectorXd solve(const std::vector<int>& active, const Eigen::VectorXd& gap);

 private:
  const ContactProblem& problem_;
  std::vector<int> active_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// Cholesky factor of a flexibility that may be singular to rounding: shifted by 1e-12 of its largest diagonal entry
/// where need be. @returns false if even then it is not positive definite
bool factor_semidefinite(const Eigen::MatrixXd& matrix, Eigen::LLT<Eigen::MatrixXd>& factor);

}  // namespace creepcontact::contact
