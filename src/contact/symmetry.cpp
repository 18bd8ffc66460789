#include "symmetry.hpp"

namespace creepcontact::contact {
namespace {

Vector3 without_held_part(const Vector3& direction, std::int64_t node, const mechanics::Constraints& constraints) {
  const Matrix3 frame = constraints.frame(node);
  Vector3 rest = direction;
  for (int k = 0; k < constraints.n_held(node); ++k) rest -= frame.col(k).dot(direction) * frame.col(k);
  return rest;
}

}  // namespace

double held_part(const Vector3& direction, std::int64_t node, const mechanics::Constraints& constraints) {
  return (direction - without_held_part(direction, node, constraints)).norm();
}

Vector3 lay_into_symmetry_planes(const Vector3& normal, std::int64_t node, const mechanics::Constraints& constraints) {
  const Vector3 projected = without_held_part(normal, node, constraints);
  return projected.norm() > 0.7 ? Vector3(projected.normalized()) : normal;
}

}  // namespace creepcontact::contact
