#pragma once
/// Meshes by the Gmsh library: .geo meshed in process, .msh 2.2 and 4.1 read, ASCII or binary.

#include <filesystem>
#include <map>
#include <string>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

struct GmshOptions {
  /// .geo only: 1 or 2; 2 means serendipity hexahedra and wedges (hex20, wedge15, quad8).
  int order = 1;
  /// .geo only: values for numbers that the file makes with DefineConstant, by variable name.
  std::map<std::string, double> parameters;
};

/// The cells of the physical groups with their nodes; nodes that no such cell uses are dropped, cells keep one number
/// in however many groups they are. A physical group without a name is named by its number as text ("7"). Names are
/// unique over the dimensions. The result depends on file and options alone: one thread, default random seed, blocks
/// ordered by cell type and cells by Gmsh's tag. Not to be called from two threads at a time (the Gmsh library has one
/// global state).
/// @throws ModelError if the file cannot be read or meshed (with Gmsh's own errors), has no physical volume, or holds
///         cells of a kind this program has no element for (naming kind and group)
/// @throws ConfigError for options that do not fit the file: order other than 1 or 2, parameters for a .msh, or a
///         parameter that is no constant of the .geo (naming those that exist)
mesh::Mesh read_mesh(const std::filesystem::path& file, const GmshOptions& options = {});

}  // namespace creepcontact::io
