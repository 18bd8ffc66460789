#include "probe_quantity.hpp"

#include <Eigen/Geometry>

namespace creepcontact::results {
namespace {

constexpr double along_x = 1e-8;  // sine of the angle between an axis and x

Vector3 vector(const std::array<double, 3>& from) {
  return {from[0], from[1], from[2]};
}

}  // namespace

ProbeQuantity::ProbeQuantity(const config::Probe& probe)
    : quantity_(quantity(probe.quantity)), origin_(vector(probe.origin)) {
  const Vector3 axis = vector(probe.axis).normalized();
  Vector3 across = Vector3::UnitX() - axis.x() * axis;
  if (across.norm() < along_x) across = Vector3::UnitY() - axis.y() * axis;
  axes_.row(0) = across.normalized().transpose();
  axes_.row(2) = axis.transpose();
  axes_.row(1) = axis.cross(across.normalized()).transpose();
}

double ProbeQuantity::operator()(const Sample& sample) const {
  if (!variable().cylindrical) return quantity_.value(sample);
  Sample turned = sample;
  turned.position = axes_ * (sample.position - origin_);
  turned.stress = tensor::from_matrix(axes_ * tensor::to_matrix(sample.stress) * axes_.transpose());
  return quantity_.value(turned);
}

}  // namespace creepcontact::results
