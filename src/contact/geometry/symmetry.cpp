#include "symmetry.hpp"

namespace creepcontact::contact {

Vector3 SymmetryPlanes::without_held_part(const Vector3& direction, std::int64_t node) const {
  if (constraints_ == nullptr || excluded_.contains(node)) return direction;
  const Matrix3 frame = constraints_->frame(node);
  Vector3 rest = direction;
  for (int k = 0; k < constraints_->n_held(node); ++k) rest -= frame.col(k).dot(direction) * frame.col(k);
  return rest;
}

double SymmetryPlanes::held_part(const Vector3& direction, std::int64_t node) const {
  return (direction - without_held_part(direction, node)).norm();
}

Vector3 SymmetryPlanes::lay(const Vector3& normal, std::int64_t node) const {
  const Vector3 projected = without_held_part(normal, node);
  if (projected.norm() > 0.7) return projected.normalized();
  return normal;
}

}  // namespace creepcontact::contact
