#pragma once
/// Protocol between the program and creepcontact-mesher, the process that meshes .geo files and reads other meshes. The
/// mesher writes the mesh as .msh 4.1 to a given descriptor and the messages of Gmsh to standard output and error; its
/// exit status tells how it ended.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

/// A half of a CAD model that is kept.
struct CadCut {
  int axis = 0;  ///< 0, 1, 2: the plane is across x, y, z
  double at = 0;
  bool keeps_larger = true;  ///< coordinates
};

/// How a CAD model is read and meshed. Faces are named by their numbers in the model after the cuts.
struct CadRequest {
  std::string unit = "MM";  ///< of the mesh, to which the lengths of the file are converted: M, MM, CM, INCH, FT
  double metres = 1e-3;     ///< the same unit of length in metres
  std::vector<CadCut> cuts;
  bool surfaces_only = false;  ///< a mesh of the surfaces alone, whatever its names
  double size = 0;             ///< of the elements; 0: a part of the size of the model
  double per_circle = 0;       ///< elements per full circle of a curved face; 0: curvature does not count
  struct Size {
    std::vector<int> faces;   ///< sizes there and near them, or ...
    std::vector<int> solids;  ///< ... within these
    double size = 0;
  };
  std::vector<Size> sizes;
  std::map<std::string, std::vector<int>> surfaces;  ///< physical surfaces, by name
};

/// What a CAD model consists of, which the mesher tells before the mesh.
struct CadFacts {
  struct Solid {
    int number = 0;
    std::string name;        ///< of its part in the file, else "solid_1"; pieces of one solid share it
    std::vector<int> faces;  ///< numbers, negative where the normal of the face points inwards
  };
  struct Face {
    int number = 0;
    double area = 0;
  };
  std::vector<Solid> solids;
  std::vector<Face> faces;
  int n_loose = 0;  ///< faces of no solid

  std::string text() const;  ///< one line
  /// Inverse of text(). @throws ModelError if the text is not of that form
  static CadFacts from(std::string_view text);
};

/// Arguments of the mesher.
struct MesherRequest {
  std::filesystem::path file;
  int dimension = 3;  ///< of the cells that carry material
  int order = 1;
  std::map<std::string, double> parameters;
  int memory_limit_mb = 0;             ///< [MB]; 0: no bound
  bool trusted = false;                ///< true: the file may run programs and write files
  bool needs_confinement = false;      ///< true: refuse to mesh if the system has no seccomp
  std::optional<CadRequest> cad = {};  ///< of a CAD file; then CadFacts come before the mesh, as the first line

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
