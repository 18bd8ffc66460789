#pragma once
/// Meshes of Salome and code_aster (.med), by libmedc.

#include <filesystem>

#include "creepcontact/io/msh/msh_content.hpp"

namespace creepcontact::mesher {

/// The first mesh of a file, with its groups of cells and of nodes; without groups each dimension is one group. Cells
/// that are numbered the other way round are turned. Warnings on standard error: several meshes, kinds of cells that
/// are left out. @throws ModelError if the file is not a .med file, is of a newer version, has no mesh of cells, or is
/// damaged
io::MshContent read_med(const std::filesystem::path& file);

}  // namespace creepcontact::mesher
