#pragma once
/// The surface of a mesh, and the cells of its groups as faces.

#include <span>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {

/// Faces that belong to one cell only, oriented outward, in the order of the cells; of surface cells their outer edges.
/// Faces are the same if they have the same corners. @param dimension  of the cells taken, 2 or 3
/// Cost: a sort of all faces.
std::vector<Face> outer_faces(std::span<const CellBlock> blocks, int dimension);

/// The cells of a group, each with its nodes.
std::vector<Face> cells_of_group(const Mesh& mesh, const Group& group);

/// The corners of a face, ascending: they identify it.
std::vector<std::int64_t> corners_of(const Face& face);

}  // namespace creepcontact::mesh
