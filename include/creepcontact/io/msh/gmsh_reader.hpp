#pragma once
/// Meshes from Gmsh files: .geo is meshed by the Gmsh library in a separate process, .msh 2.2 and 4.1 are read.

#include <filesystem>
#include <map>
#include <string>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// How to read a mesh file.
struct GmshOptions {
  /// .geo only: order 1 or 2; 2 means serendipity hexahedra and wedges (hex20, wedge15, quad8).
  int order = 1;
  /// .geo only: values of constants defined with DefineConstant, by name.
  std::map<std::string, double> parameters = {};
  double time_limit = 0;    ///< .geo only: bound on the meshing time [s]; 0: none
  int memory_limit_mb = 0;  ///< .geo only: bound on the memory for meshing [MB]; 0: none
  /// .geo only: the file may run programs, write files and use the network. Otherwise statements that do so are errors,
  /// and the meshing process is denied these rights (seccomp). On systems without seccomp the statements are still
  /// errors, and so are file names that the .geo computes.
  bool trusted = false;
  mesh::Section section = {};  ///< what the mesh represents; becomes Mesh::section
};

/// Keeps the cells of the physical groups and their nodes. A cell in several groups is stored once; nodes used by no
/// such cell are dropped. A physical group without a name is named by its number ("7"). Names are unique over all
/// dimensions. The result depends only on file and options: one thread, default random seed, blocks ordered by cell
/// type, cells by tag.
/// @throws ModelError if the file cannot be read or meshed, with the errors of Gmsh, or with its last output if it
/// crashed or was ended for time, memory or a forbidden statement. Also as import_msh.
/// @throws ConfigError for options that do not fit the file: an order other than 1 or 2, parameters for a .msh, or a
/// parameter that is not a constant of the .geo (listing the existing ones)
mesh::Mesh read_mesh(const std::filesystem::path& file, const GmshOptions& options = {});

}  // namespace creepcontact::io
