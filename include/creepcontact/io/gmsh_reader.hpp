#pragma once
/// Meshes from Gmsh's files: .geo meshed by the Gmsh library in a process of its own, .msh 2.2 and 4.1 read.

#include <filesystem>
#include <map>
#include <string>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

struct GmshOptions {
  /// .geo only: 1 or 2; 2 means serendipity hexahedra and wedges (hex20, wedge15, quad8).
  int order = 1;
  /// .geo only: values for numbers that the file makes with DefineConstant, by variable name.
  std::map<std::string, double> parameters = {};
  double time_limit = 0;    ///< .geo only: seconds that meshing may take; 0: as long as it takes
  int memory_limit_mb = 0;  ///< .geo only: memory that meshing may take; 0: as much as there is
  /// .geo only: the file may run programs, write files and use the network. Else statements that do are errors, and the
  /// process that meshes is denied the right (seccomp). Where the system has no seccomp, the statements are errors
  /// still, and so are files whose names the .geo computes.
  bool trusted = false;
};

/// The cells of the physical groups with their nodes; nodes that no such cell uses are dropped, cells keep one number
/// in however many groups they are. A physical group without a name is named by its number as text ("7"). Names are
/// unique over the dimensions. The result depends on file and options alone: one thread, default random seed, blocks
/// ordered by cell type and cells by Gmsh's tag.
/// @throws ModelError if the file cannot be read or meshed (with Gmsh's own errors, or its last words if it crashed or
///         was ended for time, memory or a statement that reaches beyond the mesh), and as read_msh
/// @throws ConfigError for options that do not fit the file: order other than 1 or 2, parameters for a .msh, or a
///         parameter that is no constant of the .geo (naming those that exist)
mesh::Mesh read_mesh(const std::filesystem::path& file, const GmshOptions& options = {});

}  // namespace creepcontact::io
