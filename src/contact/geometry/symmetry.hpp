#pragma once
/// What the supports tell of planes of symmetry: a direction held at a node is the normal of one, unless the surface
/// meets it obliquely.

#include <unordered_set>

#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::contact {

class SymmetryPlanes {
 public:
  /// No planes.
  SymmetryPlanes() = default;
  /// @param constraints  must outlive the object
  explicit SymmetryPlanes(const mechanics::Constraints& constraints) : constraints_(&constraints) {}

  /// The surface goes on beyond the supported plane in another direction than its mirror image: no symmetry here.
  void exclude(std::int64_t node) { excluded_.insert(node); }
  /// Length of the part of a unit vector that lies in the node's held directions.
  double held_part(const Vector3& direction, std::int64_t node) const;
  /// The normal without that part. A normal that is itself held stays what it is.
  Vector3 lay(const Vector3& normal, std::int64_t node) const;

 private:
  Vector3 without_held_part(const Vector3& direction, std::int64_t node) const;

  const mechanics::Constraints* constraints_ = nullptr;
  std::unordered_set<std::int64_t> excluded_;
};

}  // namespace creepcontact::contact
