#pragma once
/// Elements that integrate without complaint and are wrong all the same.

#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// Centres of the quadratic volume elements that are folded at a corner (Jacobian <= 0 there), though perhaps not at
/// the integration points: mid-edge nodes lie too far from the middle of their edges. Cost: one Jacobian a corner.
std::vector<Vector3> folded_elements(const mesh::Mesh& mesh);

}  // namespace creepcontact::mechanics
