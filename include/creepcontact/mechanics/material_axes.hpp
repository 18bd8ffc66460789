#pragma once
/// The axes of a material as functions of the place: the grain of a forged disc, the lattice of a crystal.

#include <array>
#include <span>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/section.hpp"

namespace creepcontact::mechanics {

/// Two directions as functions of x, y, z. Axis 1 is the first one; axis 2 is the second one less its part along axis
/// 1; axis 3 is at right angles to both. Directions may have any length.
struct MaterialAxes {
  std::array<Function, 3> first, second;

  /// @returns an orthonormal matrix, its columns axes 1, 2 and 3
  /// @throws ModelError if the directions vanish or are parallel there
  Matrix3 at(const Vector3& place) const;
  /// One matrix for all places if the directions are constant, else one per place.
  /// @throws ModelError as at(); also if in a section no axis is at right angles to its plane
  std::vector<Matrix3> at_points(std::span<const Vector3> places, const mesh::Section& section) const;
};

}  // namespace creepcontact::mechanics
