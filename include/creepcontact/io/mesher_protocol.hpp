#pragma once
/// How the program and creepcontact-mesher, the process that meshes .geo files for it, speak with each other.
/// The mesher writes the mesh as .msh 4.1 to a descriptor that it is given, Gmsh's messages to its standard output and
/// error, and says by its exit status how it ended.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace creepcontact::io {

struct MesherRequest {
  std::filesystem::path file;
  int order = 1;
  std::map<std::string, double> parameters;
  int memory_limit_mb = 0;         ///< 0: none
  bool trusted = false;            ///< the file may run programs and write files
  bool needs_confinement = false;  ///< refuse to mesh where the system offers no seccomp

  std::vector<std::string> arguments() const;
  /// @throws ConfigError if they are not what arguments() makes
  static MesherRequest from(const std::vector<std::string>& arguments);
};

namespace mesher {

constexpr int mesh_descriptor = 3;

/// Lines that begin so are the mesher's, not Gmsh's.
constexpr const char* mark = "mesher: ";

enum Status {
  done = 0,
  gmsh_failed = 3,
  reached_out = 81,  ///< the file would run a program, write a file or reach the network
  out_of_memory = 82,
  not_confined = 83,   ///< confinement was needed and is not to be had
  ended_by_file = 84,  ///< Exit in the file
};

}  // namespace mesher
}  // namespace creepcontact::io
