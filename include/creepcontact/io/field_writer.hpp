#pragma once
/// Fields for ParaView: <name>.pvd and <name>/<name>_NNNN.vtu (XML, appended, zlib-compressed).

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/io/csv_file.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Words in the field data of every file, as the names of the bodies: the component names of an array of their numbers.
struct TextArray {
  std::string name;
  std::vector<std::string> values;
};

/// Points and cells of all bodies, or of surfaces; the caller merges them. Node numbering within the cells is Gmsh's.
struct FieldMesh {
  std::vector<Vector3> points;
  std::vector<mesh::CellBlock> blocks;
  std::vector<TextArray> texts = {};

  /// Appends a body's points and its cells of dimension 3; values of point and cell data go in the same order.
  void append(const mesh::Mesh& body);
  std::size_t n_cells() const;
};

/// `values` is n x components, row by row; n = points of the mesh, or cells in the order of its blocks.
/// Symmetric tensors have 6 components in the order xx, yy, zz, xy, yz, zx, as ParaView names them (not Mandel: no
/// sqrt2).
struct FieldData {
  std::string name;
  int components = 1;  ///< 1, 3 or 6
  std::vector<double> values;
  std::vector<std::string> component_names = {};  ///< none, or one a component
};

/// An array as it stands in a .vtu: VTK's name of the number type, and the bytes compressed and encoded.
struct EncodedArray {
  std::string type, name;
  int components = 1;
  std::string data;
  std::vector<std::string> component_names = {};
};

/// Writes one .vtu a time and keeps <name>.pvd, the list of them, complete; both appear under their names when whole.
class FieldWriter {
 public:
  /// Compresses the geometry once, for all times. Beginning anew removes nothing but overwrites files of the same name;
  /// resuming keeps the entries of the list up to `last_time`.
  /// @param directory  of the list; @param name  stem of all files; @param units  echoed as field data `units`
  /// @throws ConfigError if the directories cannot be made or, resuming, the list cannot be understood
  FieldWriter(std::filesystem::path directory, std::string name, const FieldMesh& mesh, const std::string& units,
              Continuation continuation = {});

  /// @returns path of the .vtu written
  /// @throws std::invalid_argument if the size of an array fits neither the mesh nor its components
  /// @throws Error if the disk does not take the file
  /// Cost: compression of the arrays, some 50 MB/s.
  std::filesystem::path write(double time, const std::vector<FieldData>& point_data,
                              const std::vector<FieldData>& cell_data);

 private:
  struct Entry {
    double time;
    std::string file;
  };
  std::string file_name(std::size_t number) const;
  std::filesystem::path list_path() const;
  void write_collection() const;
  void read_collection(double last_time);

  std::filesystem::path directory_;
  std::string name_;
  std::vector<TextArray> texts_;
  std::size_t n_points_, n_cells_;
  EncodedArray points_;
  std::vector<EncodedArray> cells_;  // connectivity, offsets, types
  std::size_t first_ = 0;            ///< number of the first file of this collection
  std::vector<Entry> entries_;
};

}  // namespace creepcontact::io
