#pragma once
/// Which simple surface a piece of a mesh represents: a plane, a cylinder, a cone, a sphere or a torus.

#include <array>
#include <span>
#include <string_view>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::mesh {

enum class ShapeKind { plane, cylinder, cone, sphere, torus, other };

/// "plane", "cylinder", ...
std::string_view name_of(ShapeKind kind);

struct SurfaceShape {
  ShapeKind kind = ShapeKind::other;
  double radius = 0;        ///< cylinder, sphere; cone: the largest one; torus: of its centre line
  double minor_radius = 0;  ///< cone: the smallest one; torus: of its tube
  Vector3 center =
      Vector3::Zero();             ///< sphere, torus; cylinder, cone: on the axis, in the middle; plane: in the middle
  Vector3 axis = Vector3::Zero();  ///< of length 1; plane: its normal, outward
  bool is_hollow = false;          ///< the outward normals point to the axis or the centre, as those of a bore do
};

/// A flat triangle of a surface; by the right-hand rule its corners give the outward normal.
struct Facet {
  std::array<Vector3, 3> corners;
  Vector3 doubled_area() const { return (corners[1] - corners[0]).cross(corners[2] - corners[0]); }
  Vector3 center() const { return (corners[0] + corners[1] + corners[2]) / 3; }
  double area() const { return doubled_area().norm() / 2; }
};

/// The simplest shape on which all corners lie, within 1e-4 of the size of the piece, and whose normals are those of
/// the facets; of several the one whose normals fit best. @param facets  at least one
/// Cost: a few least-squares fits to at most 2000 facets
SurfaceShape fit_shape(std::span<const Facet> facets);

}  // namespace creepcontact::mesh
