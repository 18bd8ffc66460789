#include "creepcontact/linalg/dense.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg {
namespace {

/// Entries without pattern, the same in every run.
Eigen::MatrixXd any_matrix(Index rows, Index columns) {
  Eigen::MatrixXd matrix(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) matrix(i, j) = std::sin(1.0 + 7.3 * double(i) + 2.1 * double(i * j + j));
  return matrix;
}

double off(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(Dense, PseudoInverseFulfilsMoorePenrose) {
  const Eigen::MatrixXd columns = any_matrix(6, 3), a = columns * columns.transpose();  // rank 3
  const Eigen::MatrixXd x = symmetric_pseudo_inverse(a, 1e-10);
  EXPECT_LT(off(a * x * a, a), 1e-12);
  EXPECT_LT(off(x * a * x, x), 1e-9);
  EXPECT_LT(off(a * x, (a * x).transpose()), 1e-11);
  const Matrix3 plane = Vector3(4, 0.25, 0).asDiagonal();
  EXPECT_LT(off(symmetric_pseudo_inverse(plane, 1e-12), Vector3(0.25, 4, 0).asDiagonal().toDenseMatrix()), 1e-15);
}

TEST(Dense, NullSpaceOfManyRowsOfFewAndOfNone) {
  Eigen::MatrixXd rows = any_matrix(40, 5);
  rows.col(3) = 2 * rows.col(0) - rows.col(4);
  for (const Index n : {40, 2}) {
    const Eigen::MatrixXd space = null_space(rows.topRows(n), 1e-9);
    EXPECT_EQ(space.cols(), n == 40 ? 1 : 3);
    EXPECT_LT((rows.topRows(n) * space).norm(), 1e-12);
    EXPECT_LT(off(space.transpose() * space, Eigen::MatrixXd::Identity(space.cols(), space.cols())), 1e-14);
  }
  EXPECT_EQ(null_space(Eigen::MatrixXd(0, 4), 1e-9), Eigen::MatrixXd::Identity(4, 4));
}

TEST(Dense, SingularValuesRebuildTheMatrix) {
  for (const auto& [m, n] : {std::pair(7, 3), std::pair(3, 7)}) {
    const Eigen::MatrixXd a = any_matrix(m, n);
    const SingularValues svd = singular_values(a);
    EXPECT_LT(off(svd.left * svd.values.asDiagonal() * svd.right.transpose(), a), 1e-13);
    const RightSingularVectors right = right_singular_vectors(a);
    EXPECT_EQ(right.vectors.cols(), n);
    EXPECT_LT(off(right.values.head(3), svd.values.head(3)), 1e-13);
    const Eigen::MatrixXd r = triangular_factor(a);
    EXPECT_LT(off(r.transpose() * r, a.transpose() * a), 1e-13);
  }
  EXPECT_EQ(singular_values(Eigen::MatrixXd(0, 4)).right.rows(), 4);
}

TEST(Dense, LeastSquaresHasTheLeastNorm) {
  const Eigen::MatrixXd a = any_matrix(2, 5), b = any_matrix(2, 3);
  const Eigen::MatrixXd x = least_squares(a, b);
  EXPECT_LT(off(a * x, b), 1e-13);
  EXPECT_LT((null_space(a, 1e-9).transpose() * x).norm(), 1e-13);
}

TEST(Dense, BasisAndPivots) {
  Eigen::MatrixXd a = any_matrix(8, 3);
  const Eigen::MatrixXd q = orthonormal_basis(a);
  EXPECT_LT(off(q.transpose() * q, Eigen::MatrixXd::Identity(3, 3)), 1e-14);
  EXPECT_LT(off(q * (q.transpose() * a), a), 1e-13);
  a.col(1) *= 100;
  EXPECT_EQ(column_pivots(a)[0], 1);
}

TEST(Dense, SymmetricEigenAscends) {
  const Eigen::MatrixXd b = any_matrix(5, 5), a = b + b.transpose();
  const SymmetricEigen eigen = symmetric_eigen(a);
  EXPECT_LT(off(eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose(), a), 1e-13);
  EXPECT_TRUE(std::is_sorted(eigen.values.begin(), eigen.values.end()));
}

}  // namespace
}  // namespace creepcontact::linalg
