#include "probe_quantity.hpp"

#include <Eigen/Geometry>

namespace creepcontact::results {
namespace {

constexpr double along_x = 1e-8;  // sine of the angle between an axis and x

Vector3 vector(const std::array<double, 3>& from) {
  return {from[0], from[1], from[2]};
}

}  // namespace

Matrix3 cylindrical_axes(const Vector3& axis) {
  const Vector3 unit = axis.normalized();
  Vector3 across = Vector3::UnitX() - unit.x() * unit;
  if (across.norm() < along_x) across = Vector3::UnitY() - unit.y() * unit;
  Matrix3 axes;
  axes.row(0) = across.normalized().transpose();
  axes.row(1) = unit.cross(across.normalized()).transpose();
  axes.row(2) = unit.transpose();
  return axes;
}

Sample turned(const Sample& sample, const Matrix3& axes, const Vector3& origin) {
  Sample result = sample;
  result.position = axes * (sample.position - origin);
  result.stress = tensor::from_matrix(axes * tensor::to_matrix(sample.stress) * axes.transpose());
  return result;
}

ProbeQuantity::ProbeQuantity(const config::Probe& probe)
    : quantity_(quantity(probe.quantity)), axes_(cylindrical_axes(vector(probe.axis))), origin_(vector(probe.origin)) {}

double ProbeQuantity::operator()(const Sample& sample) const {
  return quantity_.value(variable().cylindrical ? turned(sample, axes_, origin_) : sample);
}

}  // namespace creepcontact::results
