#pragma once
/// Results as CalculiX writes them: one .frd file (ASCII, long format) that cgx and PrePoMax open.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_file.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::io {

/// Values at the nodes of all bodies. Nodes where all components of a row are NaN are left out.
struct FrdField {
  enum class Kind { scalars = 1, vector = 2, tensor = 4 };  ///< numbers of the format
  std::string name;                                         ///< at most 8 letters: DISP, STRESS
  std::vector<std::string> components;                      ///< at most 8 letters each; at most 6
  Kind kind = Kind::scalars;                                ///< tensors: xx, yy, zz, xy, yz, zx
  std::vector<double> values;                               ///< row by row; nodes of one body after those of the other
};

/// Nodes and elements bear their numbers of the mesh file; without numbers they are counted from 1. Where bodies share
/// a node, it has the mean of their values. hex27 and quad9 are written without their inner nodes.
/// Source: CalculiX CrunchiX, and the manual of CalculiX GraphiX, "Result format".
class FrdWriter {
 public:
  /// Starts a new file with the mesh. When resuming, keeps the results up to last_time and goes on after them; a
  /// missing file is started again.
  /// @param bodies  used during the call only
  /// @throws ConfigError if the file cannot be opened
  FrdWriter(std::filesystem::path path, const std::vector<const mesh::Mesh*>& bodies, Continuation continuation = {});

  /// @throws std::invalid_argument if a field has values of other nodes @throws Error if the disk cannot take them
  void write(double time, const std::vector<FrdField>& fields);
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void number_nodes(const std::vector<const mesh::Mesh*>& bodies);
  std::string mesh_text(const std::vector<const mesh::Mesh*>& bodies) const;
  void append(const FrdField& field, double time, std::string& text) const;
  void open();
  void put(const std::string& text);

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::int64_t> numbers_;  // ascending, of the nodes in the file
  std::vector<std::size_t> place_;     // in numbers_, of the nodes of all bodies one after the other
  int n_steps_ = 0;
};

}  // namespace creepcontact::io
