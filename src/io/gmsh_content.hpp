#pragma once
/// Gmsh's current model as the content of a .msh file.

#include "creepcontact/io/msh_content.hpp"

namespace creepcontact::io {

/// All nodes and elements, and the physical groups of the entities.
MshContent gmsh_content();

}  // namespace creepcontact::io
