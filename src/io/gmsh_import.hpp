#pragma once
/// Gmsh's current model as a Mesh.

#include <string>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// @param file  name for messages
/// @param cells_may_repeat  format 2.2 writes a cell once for each of its groups
/// @throws ModelError  as read_mesh
mesh::Mesh import_model(const std::string& file, bool cells_may_repeat);

}  // namespace creepcontact::io
