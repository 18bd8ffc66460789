#pragma once
/// Nodes on the axis of rotation of an axisymmetric section.

#include <cstdint>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {

/// Nodes at x = 0, ascending, within 1e-9 of the largest radius.
/// @pre  mesh.section.is_axisymmetric()
/// Cost: one pass over all nodes.
std::vector<std::int64_t> axis_nodes(const Mesh& mesh);

}  // namespace creepcontact::mesh
