#pragma once
/// Meshes of sections: flat, their cells counter-clockwise.

#include <string>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Turns surface cells that are clockwise, and sets Section::axial_length to the size of the mesh. @param mesh  of a
/// section @param file  name for messages
/// @throws ModelError if a node is not in the plane z = 0, or in an axisymmetric section at a negative radius
void check_plane_mesh(mesh::Mesh& mesh, const std::string& file);

}  // namespace creepcontact::io
