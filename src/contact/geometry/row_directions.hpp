#pragma once
/// Directions of the rows of each multiplier.

#include <array>
#include <optional>
#include <vector>

#include "continued_surface.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"
#include "plane_holding.hpp"

namespace creepcontact::contact {

/// Directions of the multipliers of a slave surface, at their nodes.
class RowDirections {
 public:
  /// @param normals, continued  of the surface, which must outlive the object
  /// @param friction  adds tangents; unilateral contacts only
  RowDirections(ContactType type, bool friction, const SurfaceNormals& normals, const ContinuedSurface& continued,
                const Surface& surface);

  /// Rows per multiplier: 1, with friction 2 in sections and 3 in solids, tied 3.
  int width() const { return width_; }
  /// Tied: orthonormal, x, y and z unless a plane of symmetry holds another direction. Otherwise the normal and two
  /// tangents, the first along a direction that a support holds, if there is one.
  const Matrix3& axes(int multiplier) const { return axes_[static_cast<std::size_t>(multiplier)]; }
  /// True if a plane of symmetry holds the slave along this direction (PlaneHolding).
  bool is_held(int multiplier, int direction) const {
    return held_[static_cast<std::size_t>(multiplier)][static_cast<std::size_t>(direction)];
  }
  /// How planes of symmetry hold the slave; nothing in unilateral contacts without friction, where it does not matter.
  const std::optional<PlaneHolding>& holding() const { return holding_; }
  bool is_any_held(int multiplier) const {
    return is_held(multiplier, 0) || is_held(multiplier, 1) || is_held(multiplier, 2);
  }

 private:
  std::optional<PlaneHolding> holding_;
  int width_;
  std::vector<Matrix3> axes_;
  std::vector<std::array<bool, 3>> held_;
};

}  // namespace creepcontact::contact
