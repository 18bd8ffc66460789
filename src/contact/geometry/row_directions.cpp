#include "row_directions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr double same_direction = 1e-6;

bool is_along(const Vector3& direction, const Vector3& other) {
  return direction.cross(other).norm() <= same_direction;
}

/// Tangents of a multiplier. A direction that a support holds comes first: along it nothing moves and nothing slides.
/// @param held  directions along the surface that planes of symmetry hold
std::array<Vector3, 2> tangents(const MultiplierNode& at, const mesh::Mesh& mesh,
                                const mechanics::Constraints& constraints, const std::vector<Vector3>& held) {
  constexpr double along_surface = 0.99;
  const Vector3& normal = at.normal;
  if (mesh.section.dimension() == 2) return {Vector3(-normal.y(), normal.x(), 0), Vector3(Vector3::UnitZ())};
  Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  Vector3 first = Vector3::Unit(least);
  const Matrix3 frame = constraints.frame(at.node);
  for (int k = constraints.n_held(at.node) - 1; k >= 0; --k)
    if (normal.cross(frame.col(k)).norm() > along_surface) first = frame.col(k);
  const auto fits = [&](const Vector3& direction) {
    return is_along(first, direction) || is_along(normal.cross(first), direction);
  };
  if (!held.empty() && std::ranges::none_of(held, fits)) first = held.front();
  first = (first - normal.dot(first) * normal).normalized();
  return {first, normal.cross(first)};
}

/// x, y and z, or axes that begin with the held directions.
Matrix3 tied_axes(const std::vector<Vector3>& held) {
  const auto is_axis = [](const Vector3& direction) {
    return direction.cwiseAbs().maxCoeff() >= 1 - same_direction * same_direction;
  };
  if (std::ranges::all_of(held, is_axis)) return Matrix3::Identity();
  const Vector3 second = held.size() > 1 ? held[1] : Vector3(held[0].unitOrthogonal());
  Matrix3 axes;
  axes << held[0], second, held[0].cross(second);
  return axes;
}

}  // namespace

RowDirections::RowDirections(ContactType type, bool friction, const SurfaceNormals& normals,
                             const ContinuedSurface& continued, const Surface& surface)
    : width_(type == ContactType::tied ? 3
             : friction                ? surface.mesh->section.dimension()
                                       : 1) {
  if (width_ > 1) holding_.emplace(surface);
  for (const MultiplierNode& at : normals.multipliers) {
    std::vector<Vector3> held;
    if (holding_ && static_cast<std::size_t>(at.node) < surface.mesh->nodes.size())
      held = holding_->directions(at.node, at.normal);
    Matrix3 axes;
    if (type == ContactType::tied) {
      axes = tied_axes(held);
    } else if (friction) {
      const auto [first, second] = tangents(at, continued.mesh(), continued.constraints(), held);
      axes << at.normal, first, second;
    } else {
      axes << at.normal, Vector3::Zero(), Vector3::Zero();
    }
    axes_.push_back(axes);
    auto& is_held = held_.emplace_back();
    for (int k = 0; k < 3; ++k)
      is_held[static_cast<std::size_t>(k)] =
          std::ranges::any_of(held, [&](const Vector3& direction) { return is_along(axes.col(k), direction); });
    if (type != ContactType::tied) is_held[0] = false;
  }
}

}  // namespace creepcontact::contact
