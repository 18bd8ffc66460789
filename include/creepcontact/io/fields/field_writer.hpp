#pragma once
/// Field files for ParaView: <name>.pvd and <name>/<name>_NNNN.vtu (XML around raw data, zlib-compressed).

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_file.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Texts stored in the field data of every file, such as the names of bodies. They are the component names of an array
/// of numbers.
struct TextArray {
  std::string name;
  std::vector<std::string> values;
};

/// Points and cells of all bodies, or of surfaces, collected by the caller. Node numbering within cells is that of
/// Gmsh.
struct FieldMesh {
  std::vector<Vector3> points;
  std::vector<mesh::CellBlock> blocks;
  std::vector<TextArray> texts = {};

  /// Appends the points and the volume cells of a body; point and cell data must follow the same order.
  void append(const mesh::Mesh& body);
  std::size_t n_cells() const;
};

/// `values` is n x components, row by row; n = points of the mesh, or cells in the order of its blocks. Symmetric
/// tensors have 6 components in the order xx, yy, zz, xy, yz, zx, as ParaView names them (not Mandel: without sqrt2).
struct FieldData {
  std::string name;
  int components = 1;  ///< 1, 3 or 6
  std::vector<double> values;
  std::vector<std::string> component_names = {};  ///< empty, or one per component
};

/// An array as stored in a .vtu: the VTK name of the number type, and the compressed bytes.
struct EncodedArray {
  std::string type, name;
  int components = 1;
  std::string data;
  std::vector<std::string> component_names = {};
};

/// Writes one .vtu per time and keeps their list <name>.pvd complete. Both get their names only when complete, so that
/// the end of the program, however sudden, leaves no broken file; take_unsynced() names those that
/// a power cut may still undo.
class FieldWriter {
 public:
  /// Compresses the geometry once, for all times. A new start overwrites files of the same name but removes none;
  /// resuming keeps the entries of the list up to `last_time`.
  /// @param directory  of the list @param name  stem of all files @param units  stored as field data `units`
  /// @throws ConfigError if the directories cannot be made or, when resuming, the list cannot be read
  FieldWriter(std::filesystem::path directory, std::string name, const FieldMesh& mesh, const std::string& units,
              Continuation continuation = {});

  /// @returns path of the .vtu written
  /// @throws std::invalid_argument if the size of an array does not match the mesh and its components
  /// @throws Error if the disk cannot take the file
  /// Cost: compression of the arrays, about 50 MB/s.
  std::filesystem::path write(double time, const std::vector<FieldData>& point_data,
                              const std::vector<FieldData>& cell_data);
  /// The files written since the last call, for platform::sync_files(); with the list, if there are any.
  std::vector<std::filesystem::path> take_unsynced();

 private:
  struct Entry {
    double time;
    std::string file;
  };
  std::string file_name(std::size_t number) const;
  std::filesystem::path list_path() const;
  void write_collection();
  void read_collection(double last_time);

  std::filesystem::path directory_;
  std::string name_;
  std::vector<TextArray> texts_;
  std::size_t n_points_, n_cells_;
  EncodedArray points_;
  std::vector<EncodedArray> cells_;  // connectivity, offsets, types
  std::size_t first_ = 0;            ///< number of the first file of this list
  std::vector<Entry> entries_;
  std::string listed_;  ///< the list on disk; empty: not written yet
  std::vector<std::filesystem::path> unsynced_;
};

}  // namespace creepcontact::io
