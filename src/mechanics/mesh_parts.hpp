#pragma once
/// Pieces of a mesh that can only move as rigid wholes: elements joined by faces.

#include <cstdint>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// @returns the nodes of every part, ascending; parts may share nodes (hinges)
std::vector<std::vector<std::int64_t>> mesh_parts(const mesh::Mesh& mesh);

}  // namespace creepcontact::mechanics
