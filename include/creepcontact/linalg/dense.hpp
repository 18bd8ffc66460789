#pragma once
/// Decompositions of small dense matrices. They are instantiated here once, so that no other source compiles Eigen's.
///
/// Cost: cubic in the smaller dimension. Source: Golub and Van Loan, Matrix Computations (2013), chapters 5 and 8.

#include <Eigen/Core>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::linalg {

/// A = vectors diag(values) vectors^T, values ascending, vectors orthonormal.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// @param matrix  symmetric; only its lower triangle is read
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// Inverse of a symmetric positive semidefinite matrix on the eigenvectors whose eigenvalues exceed
/// relative_limit times the largest; zero on the others.
Eigen::MatrixXd symmetric_pseudo_inverse(const Eigen::MatrixXd& matrix, double relative_limit);
Matrix3 symmetric_pseudo_inverse(const Matrix3& matrix, double relative_limit);

/// A = left diag(values) right^T, values descending. Left and right have min(rows, columns) orthonormal columns.
struct SingularValues {
  Eigen::MatrixXd left;
  Eigen::VectorXd values;
  Eigen::MatrixXd right;
};
SingularValues singular_values(const Eigen::MatrixXd& matrix);

/// The singular values of A (m x n) and all its n right singular vectors, also those that A maps to zero.
struct RightSingularVectors {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// Cheap for many rows: only their triangular factor is decomposed.
RightSingularVectors right_singular_vectors(const Eigen::MatrixXd& matrix);

/// Orthonormal basis of the vectors that A maps to less than tolerance max(1, largest singular value). The identity if
/// A has no rows.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, double tolerance);

/// Upper triangular or trapezoidal R of A = Q R, min(rows, columns) x columns.
Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix);

/// Orthonormal basis of the space of the columns, which must be independent.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

/// Indices of the columns of A, the best conditioned set first (QR with column pivoting).
Eigen::VectorXi column_pivots(const Eigen::MatrixXd& matrix);

/// The X of least norm among those that minimise |A X - B|.
/// @param threshold  below this share of the largest pivot a direction is taken for dependent; 0: rounding
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double threshold = 0);

}  // namespace creepcontact::linalg
