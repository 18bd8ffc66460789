/// What supports hold at single nodes.

#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"
#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::mechanics {
namespace {

constexpr double min_part = 1e-6;  // of a unit vector

}  // namespace

bool Constraints::holds(std::int64_t node, const Vector3& direction) const {
  if (const NodeLinks::Turned* turned = turned_or_null(node))
    return holds(turned->of, turned->rotation.transpose() * direction);
  if (const RigidSurface* surface = surface_or_null(node)) {
    const std::size_t place = std::ranges::lower_bound(surface->nodes, node) - surface->nodes.begin();
    const Vector3& arm = surface->arms[place];
    for (Index k = 0; k < surface->free.cols(); ++k) {
      const Vector3 shift = surface->free.col(k).head<3>(), turn = surface->free.col(k).tail<3>().cross(arm);
      if (std::abs(direction.dot(shift + turn)) > min_part * (shift.norm() + turn.norm())) return false;
    }
    return true;
  }
  const Matrix3 axes = frame(node);
  Vector3 rest = direction;
  for (int k = 0; k < n_held(node); ++k) rest -= axes.col(k).dot(direction) * axes.col(k);
  return rest.norm() <= min_part;
}

std::optional<std::vector<Constraints::PrescribedPart>> Constraints::prescribed_along(std::int64_t node,
                                                                                      const Vector3& direction) const {
  if (const NodeLinks::Turned* turned = turned_or_null(node))
    return prescribed_along(turned->of, turned->rotation.transpose() * direction);
  if (const RigidSurface* surface = surface_or_null(node)) {
    for (const RigidSurface::Condition& condition : surface->conditions)
      if (!condition.value.is_zero()) return std::nullopt;
    return std::vector<PrescribedPart>();
  }
  std::vector<PrescribedPart> parts;
  for (const ConditionsOfSupport& support : supports_) {
    if (support.value.is_zero()) continue;
    for (const Condition& condition : support.conditions) {
      if (condition.node != node) continue;
      const double factor = condition.displacement.dot(direction);
      if (std::abs(factor) <= min_part) continue;
      if (support.value.depends_on_position()) return std::nullopt;
      parts.push_back({factor, &support.value});
    }
  }
  return parts;
}

}  // namespace creepcontact::mechanics
