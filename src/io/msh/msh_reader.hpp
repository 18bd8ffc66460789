#pragma once
/// Gmsh's mesh files: .msh 2.2 and 4.1, ASCII and binary. Reading executes nothing, whatever the bytes are.

#include <string>
#include <string_view>

#include "creepcontact/io/msh/msh_content.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// @param bytes  the whole file; every count in it is checked against the bytes that follow before memory is taken
/// @param name   of the file, for messages
/// @throws ModelError with the line (ASCII) or the offset in bytes (binary), the section, what was found and how to
///         cure it: no or another $MeshFormat, another version, damaged or incomplete sections
/// Cost: proportional to the bytes, in time and in memory.
MshContent read_msh_content(std::string_view bytes, const std::string& name);

/// The cells of the physical groups with their nodes, as read_mesh describes them.
/// @throws ModelError  also if the content makes no model: see import_msh
mesh::Mesh read_msh(std::string_view bytes, const std::string& name, const mesh::Section& section = {});

}  // namespace creepcontact::io
