#pragma once
/// One sector of a structure with cyclic symmetry.

#include <vector>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::contact {

struct Sector {
  Matrix3 rotation = Matrix3::Identity();  ///< of one sector onto the next
  Vector3 origin = Vector3::Zero();        ///< a point of the axis
  int count = 1;                           ///< of sectors in the full circle

  /// Rotation by this number of sectors, from 0 to count - 1.
  Matrix3 turns(int sectors) const;
  /// Position in the sector that lies this number of sectors further on.
  Vector3 turned(const Vector3& position, int sectors = 1) const {
    return origin + turns(sectors) * (position - origin);
  }
  /// The adjacent sectors, as numbers of sectors further on: none, one or two.
  std::vector<int> neighbours() const;
};

}  // namespace creepcontact::contact
