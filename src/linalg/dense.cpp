#include "creepcontact/linalg/dense.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg {
namespace {

template <typename Matrix>
Matrix pseudo_inverse(const Matrix& matrix, double relative_limit) {
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(matrix);
  const auto values = eigen.eigenvalues().array().eval();
  const double limit = relative_limit * values.abs().maxCoeff();
  const auto inverse = (values > limit).select(values.inverse(), 0.0).matrix().eval();
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

Tensor6 eigenvalue_ratios(const Matrix6& a, const Matrix6& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6>(a, b, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXd symmetric_pseudo_inverse(const Eigen::MatrixXd& matrix, double relative_limit) {
  return pseudo_inverse(matrix, relative_limit);
}
Matrix3 symmetric_pseudo_inverse(const Matrix3& matrix, double relative_limit) {
  return pseudo_inverse(matrix, relative_limit);
}

SingularValues singular_values(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return {Eigen::MatrixXd(matrix.rows(), 0), {}, Eigen::MatrixXd(matrix.cols(), 0)};
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix);
  return qr.matrixQR().topRows(std::min(matrix.rows(), matrix.cols())).triangularView<Eigen::Upper>();
}

RightSingularVectors right_singular_vectors(const Eigen::MatrixXd& matrix) {
  const Index n = matrix.cols();
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(n, n);
  if (matrix.rows() > 0) square.topRows(std::min(matrix.rows(), n)) = triangular_factor(matrix);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(square, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, double tolerance) {
  if (matrix.rows() == 0) return Eigen::MatrixXd::Identity(matrix.cols(), matrix.cols());
  const RightSingularVectors right = right_singular_vectors(matrix);
  const Index rank = (right.values.array() > tolerance * std::max(1.0, right.values[0])).count();
  return right.vectors.rightCols(matrix.cols() - rank);
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

Eigen::VectorXi column_pivots(const Eigen::MatrixXd& matrix) {
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(matrix).colsPermutation().indices();
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.partialPivLu().inverse();
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  if (threshold > 0) decomposition.setThreshold(threshold);
  decomposition.compute(matrix);
  return decomposition.solve(right);
}

}  // namespace creepcontact::linalg
