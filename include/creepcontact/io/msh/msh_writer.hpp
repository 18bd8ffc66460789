#pragma once
/// Writes meshes as .msh 4.1 binary, to pass them to another program.

#include <string>

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::io {

/// Bounding boxes of entities are written as zeros, and all nodes are assigned to the entity of the first elements.
/// @throws ModelError for names of physical groups that the format cannot store: with quotation marks or line breaks
std::string write_msh(const MshContent& content);

}  // namespace creepcontact::io
