#include "creepcontact/base/tensor.hpp"

#include <Eigen/Eigenvalues>

namespace creepcontact::tensor {

Principal::Principal(const Matrix3& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(matrix);
  values = eigen.eigenvalues();
  directions = eigen.eigenvectors();
}

Vector3 principal_values(const Matrix3& matrix) {
  return Eigen::SelfAdjointEigenSolver<Matrix3>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace creepcontact::tensor
