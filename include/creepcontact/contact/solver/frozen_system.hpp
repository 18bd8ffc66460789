#pragma once
/// The linear equations of a frozen active set I, factored once a set:
///   F_II lambda_I + N_I alpha = -gap_I,   N_I^T lambda_I = -resultant
/// F_II may be singular at the pins of bodies held by contact alone; F_II + c N_I N_I^T in its place is not, and
/// changes the amplitudes by c N_I^T lambda only.

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

struct FrozenSolution {
  ContactState state;  ///< multipliers n_rows, zero off the set
  /// False if the set cannot balance the resultants (too few contacts for the loads).
  bool balanced = true;
};

class SchwarzGradients;

class FrozenSystem {
 public:
  /// @param tolerance  of the multipliers, relative, where the flexibility is an operator and the solution iterative
  explicit FrozenSystem(const ContactProblem& problem, double tolerance = 1e-10);
  ~FrozenSystem();

  /// Closes the gaps of the set. Motions that the set does not hold keep the amplitude 0.
  /// Cost: two triangular solves of the set's size; a Cholesky factorisation when the set is another than last time.
  /// With a flexibility given as an operator: conjugate gradients.
  /// @throws SolverError if the contact conditions of the set contradict or repeat each other
  FrozenSolution solve(const std::vector<int>& active, const ContactLoad& load);
  /// The flexibilities of the problem are others than before.
  void flexibility_changed();

 private:
  void factorize(const std::vector<int>& active);
  FrozenSolution solve_directly(const ContactLoad& load);
  FrozenSolution solve_iteratively(const std::vector<int>& active, const ContactLoad& load);

  const ContactProblem& problem_;
  double tolerance_;
  std::unique_ptr<SchwarzGradients> gradients_;  // of a flexibility given as an operator
  std::vector<int> active_;
  bool factored_ = false;
  double pin_flexibility_ = 0;          // c
  Eigen::LLT<Eigen::MatrixXd> factor_;  // F_II + c N_I N_I^T = L L^T
  Eigen::MatrixXd motions_;             // L^-1 N_I
  Eigen::MatrixXd coarse_inverse_;      // pseudo-inverse of motions_^T motions_
};

/// Cholesky factor of a flexibility that may be singular to rounding: shifted by 1e-12 of its largest diagonal entry
/// where need be. @returns false if even then it is not positive definite
bool factor_semidefinite(const Eigen::MatrixXd& matrix, Eigen::LLT<Eigen::MatrixXd>& factor);

}  // namespace creepcontact::contact
