#pragma once
/// A plane that cuts a body in two, for the forces that act on one of the parts.

#include <span>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/fem/quadrature.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// Immutable. "Beyond" is the side of the normal. A plane may also touch the body in faces that end it there: what acts
/// on these faces then lies on the side where there is no material, so that the plane carries it.
class Cut {
 public:
  enum class Side { behind, beyond, both };

  /// @param mesh  of the body; must outlive the object
  /// @param normal  of any length other than 0
  /// @throws ModelError if the plane misses the body, saying where the body lies
  Cut(const mesh::Mesh& mesh, const Vector3& origin, const Vector3& normal);

  const mesh::Mesh& mesh() const { return mesh_; }
  /// The side of a cell. A cell in the plane is behind.
  Side side(std::span<const std::int64_t> nodes) const;
  /// The side of a face. A face in the plane lies where its cell is, or outside of a body that ends there.
  Side side(const mesh::Face& face) const;
  /// Rule over the part beyond the plane of a cell or face that has parts on both sides.
  fem::QuadratureRule rule_beyond(mesh::CellType type, std::span<const std::int64_t> nodes) const;
  /// Share of a force at a node that acts beyond: 0 or 1; in the plane a half, or all of it where the body ends.
  double node_share(std::int64_t node) const;
  /// Area of a face times the depth of sections, and that of its part beyond.
  struct FaceArea {
    double beyond = 0, whole = 0;
  };
  FaceArea area(const mesh::Face& face) const;

 private:
  /// Distance of a node from the plane, positive beyond; 0 within the tolerance.
  double level(std::int64_t node) const { return levels_[node]; }
  bool ends_body() const { return ends_beyond_ || ends_behind_; }

  const mesh::Mesh& mesh_;
  Vector3 normal_;
  std::vector<double> levels_;                      // by node
  bool ends_beyond_ = false, ends_behind_ = false;  // the body ends at the plane, with nothing beyond or behind
};

/// A force per unit of some function, at a point.
struct FieldPoint {
  Vector3 position, field;
};

/// The forces f(x, t) factor(t)^power field at some points.
class PointForces {
 public:
  PointForces(std::vector<FieldPoint> points, Function f, Function factor, int power);

  /// Adds their resultant at time t and its moment about a point.
  void add(double t, const Vector3& about, Vector3& force, Vector3& moment) const;

 private:
  std::vector<FieldPoint> points_;
  Function f_, factor_;
  int power_;
};

}  // namespace creepcontact::mechanics
