#pragma once
/// Detection of elements that can be integrated but give wrong results.

#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// Centres of the quadratic volume elements that are folded at a corner: Jacobian <= 0 there, though perhaps not at the
/// integration points, because mid-edge nodes are too far from the middle of their edges. Cost: one Jacobian per
/// corner.
std::vector<Vector3> folded_elements(const mesh::Mesh& mesh);

}  // namespace creepcontact::mechanics
