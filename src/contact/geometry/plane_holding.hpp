#pragma once
/// Directions along which planes of symmetry, or an axis, hold multiplier nodes.
///
/// In a model that is cut at a plane of symmetry, a node of a contact on that plane has a multiplier whose component
/// along the normal of the plane is odd with respect to it, hence zero, and a relative displacement along it whose
/// weighted mean over both sides is zero as well. The row is thus fulfilled in the whole model. In the part, its test
/// function sees one side alone and would couple the neighbours, so the row must not exist.

#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "continued_surface.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

/// Which planes hold the nodes of one body's contact surface.
class PlaneHolding {
 public:
  /// @param surface  must outlive the object
  explicit PlaneHolding(const Surface& surface);

  /// Orthonormal directions along the surface, at most two, that planes of symmetry or an axis of cyclic symmetry hold
  /// at a node of the body. @param normal  of the surface there
  std::vector<Vector3> directions(std::int64_t node, const Vector3& normal) const;
  /// 1 or -1: the body lies on this side of the plane through the node with this normal, and supports hold all nodes of
  /// the elements around it that lie in the plane along the normal. 0: there is no such plane.
  int side(std::int64_t node, const Vector3& direction) const;
  bool is_on_axis(std::int64_t node) const { return on_axis_.contains(node); }
  const Vector3& position(std::int64_t node) const { return surface_.mesh->nodes[static_cast<std::size_t>(node)]; }
  const mechanics::Constraints& constraints() const { return *surface_.constraints; }

 private:
  const Surface& surface_;
  std::unordered_set<std::int64_t> on_axis_;                                                   // of cyclic symmetry
  std::unordered_map<std::int64_t, std::vector<std::span<const std::int64_t>>> cells_around_;  // of held nodes
};

/// True if a plane of symmetry or an axis that holds the slave at a node along a direction holds the master too.
/// @param facets  of the master, opposite to the node, with numbers of `surface`
bool holds_both(const PlaneHolding& slave, std::int64_t node, const Vector3& direction, const PlaneHolding& master,
                const ContinuedSurface& surface, std::span<const Facet* const> facets);

}  // namespace creepcontact::contact
