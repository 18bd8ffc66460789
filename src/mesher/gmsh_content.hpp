#pragma once
/// Gmsh's current model as the content of a .msh file.

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::mesher {

/// All nodes and elements, and the physical groups of the entities.
io::MshContent gmsh_content();

/// Makes each entity a physical group "volume_3", "surface_12": of meshes that have no groups, such as those of
/// Nastran, whose entities are its properties.
void name_entities(io::MshContent& content);

}  // namespace creepcontact::mesher
