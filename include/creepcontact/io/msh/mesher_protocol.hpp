#pragma once
/// Protocol between the program and creepcontact-mesher, the process that meshes .geo files and reads other meshes. The
/// mesher writes the mesh as .msh 4.1 to a given descriptor and the messages of Gmsh to standard output and error; its
/// exit status tells how it ended.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace creepcontact::io {

/// Arguments of the mesher.
struct MesherRequest {
  std::filesystem::path file;
  int dimension = 3;  ///< of the cells that carry material
  int order = 1;
  std::map<std::string, double> parameters;
  int memory_limit_mb = 0;         ///< [MB]; 0: no bound
  bool trusted = false;            ///< true: the file may run programs and write files
  bool needs_confinement = false;  ///< true: refuse to mesh if the system has no seccomp

  /// Command line of the mesher for this request.
  std::vector<std::string> arguments() const;
  /// Inverse of arguments(). @throws ConfigError if the arguments are not of that form
  static MesherRequest from(const std::vector<std::string>& arguments);
};

namespace mesher {

/// Descriptor to which the mesher writes the mesh.
constexpr int mesh_descriptor = 3;

/// Lines with this prefix are messages of the mesher, not of Gmsh.
constexpr const char* mark = "mesher: ";

/// Exit statuses of the mesher.
enum Status {
  done = 0,
  gmsh_failed = 3,
  reached_out = 81,  ///< the file attempts to run a program, write a file or use the network
  out_of_memory = 82,
  not_confined = 83,   ///< seccomp was required but is not available
  ended_by_file = 84,  ///< the file contains an Exit statement
};

}  // namespace mesher
}  // namespace creepcontact::io
