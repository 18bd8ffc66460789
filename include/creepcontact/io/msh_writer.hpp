#pragma once
/// .msh 4.1 binary, for a program that hands a mesh to another one.

#include <string>

#include "creepcontact/io/msh_content.hpp"

namespace creepcontact::io {

/// Bounding boxes of entities are written as zeros; all nodes belong to the entity of the first elements.
/// @throws ModelError for names of physical groups that the format cannot hold: with quotation marks or line ends
std::string write_msh(const MshContent& content);

}  // namespace creepcontact::io
