#include "creepcontact/fem/tangents.hpp"

#include <Eigen/Geometry>

namespace creepcontact::fem {

Matrix3 jacobian(const ReferenceElement& cell, const Eigen::Matrix3Xd& x, const Eigen::MatrixX3d& gradient) {
  Matrix3 result = x * gradient;
  if (cell.dimension() == 2) result.col(2) = Vector3::UnitZ();
  return result;
}

Vector3 area_vector(const ReferenceElement& face, const Eigen::Matrix3Xd& x, const Eigen::MatrixX3d& gradient) {
  const Matrix3 tangents = x * gradient;
  return tangents.col(0).cross(face.dimension() == 1 ? Vector3(Vector3::UnitZ()) : Vector3(tangents.col(1)));
}

}  // namespace creepcontact::fem
