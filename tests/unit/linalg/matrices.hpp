#pragma once
/// Matrices for the tests, by their lower triangle, with the node of every unknown.

#include <Eigen/Core>
#include <vector>

#include "../../../src/linalg/supernodal_cholesky.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg::testing {

struct Problem {
  SparseMatrix lower;
  std::vector<std::int64_t> node_of;

  Eigen::MatrixXd dense() const;
};

SparseMatrix lower_of(const Eigen::MatrixXd& dense);

Eigen::VectorXd random_vector(std::int64_t n, unsigned seed);

/// Grid of n x n x n nodes, 3 unknowns each, with the pattern of trilinear elasticity: a random positive definite
/// 24 x 24 matrix per cell. `copies` such bodies side by side, not connected.
Problem grid(int n, int copies = 1, unsigned seed = 1);

/// Random sparse diagonally dominant matrix; every unknown is a block of its own.
Problem random_sparse(int n, unsigned seed);

Eigen::VectorXd forward(StiffnessSolver& solver, const Eigen::VectorXd& b);

Eigen::VectorXd backward(StiffnessSolver& solver, const Eigen::VectorXd& y);

Eigen::VectorXd solve(StiffnessSolver& solver, const Eigen::VectorXd& b);

/// Schur complement of the trailing unknowns, in their order, by dense elimination of all others.
Eigen::MatrixXd schur_complement(const Eigen::MatrixXd& a, const std::vector<std::int64_t>& trailing);

}  // namespace creepcontact::linalg::testing
