#pragma once
/// Decompositions of small dense matrices by LAPACK: no template of Eigen for them has to be compiled. Where a
/// decomposition fails, as it may for entries that are not finite, its values are not numbers.
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

/// Eigenvalues of B^-1 A, ascending. @param a, b  symmetric, b positive definite
Tensor6 eigenvalue_ratios(const Matrix6& a, const Matrix6& b);

/// Pseudo-inverse of a symmetric positive semidefinite matrix: inverse on the eigenvectors with eigenvalues greater
/// than relative_limit times the largest, zero on the others.
Eigen::MatrixXd symmetric_pseudo_inverse(const Eigen::MatrixXd& matrix, double relative_limit);
Matrix3 symmetric_pseudo_inverse(const Matrix3& matrix, double relative_limit = 1e-12);

/// A = left diag(values) right^T, values descending. Left and right have min(rows, columns) orthonormal columns.
struct SingularValues {
  Eigen::MatrixXd left;
  Eigen::VectorXd values;
  Eigen::MatrixXd right;
};
SingularValues singular_values(const Eigen::MatrixXd& matrix);

/// Singular values of A (m x n) and all n right singular vectors, including those of the null space.
struct RightSingularVectors {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// Cheap for many rows: only the triangular factor is decomposed.
RightSingularVectors right_singular_vectors(const Eigen::MatrixXd& matrix);

/// Orthonormal basis of the vectors v with |A v| < tolerance max(1, largest singular value) |v|. The identity if A has
/// no rows.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, double tolerance);

/// Upper triangular or trapezoidal R of A = Q R, min(rows, columns) x columns.
Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix);

/// Orthonormal basis of the column space. @param columns  linearly independent
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

/// Indices of the columns of A, best conditioned subset first (QR with column pivoting).
Eigen::VectorXi column_pivots(const Eigen::MatrixXd& matrix);

/// Inverse of a square matrix, not finite if the matrix is singular (LU with partial pivoting).
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// X = L^-1 X. @param factor  L in the lower triangle, whose entries alone are read
void substitute_forward_in_all(const Eigen::MatrixXd& factor, Eigen::MatrixXd& columns);
/// X^T X
Eigen::MatrixXd products_of_columns(const Eigen::MatrixXd& columns);

/// X of A X = B. @param matrix  symmetric positive definite
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Tensor6 solve_positive(const Matrix6& matrix, const Tensor6& right);
/// Inverses of such tensors' maps without memory of their own; the first one of a positive definite map.
Matrix6 inverse_of_positive(const Matrix6& matrix);
Matrix6 inverse(const Matrix6& matrix);

/// The X of smallest norm among the minimisers of |A X - B|.
/// @param threshold  pivots below this fraction of the largest count as zero; 0: round-off
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double threshold = 0);

}  // namespace creepcontact::linalg
