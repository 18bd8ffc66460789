#pragma once
/// Reading of field files: <name>.pvd and its .vtu files, as FieldWriter writes them.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/io/fields/field_writer.hpp"

namespace creepcontact::io {

/// One time of a list of field files.
struct FieldEntry {
  double time = 0;
  std::filesystem::path file;  ///< resolved against the directory of the list
};

/// @throws ConfigError naming the file if it cannot be read or has another content
std::vector<FieldEntry> read_field_list(const std::filesystem::path& list);
/// Like read_field_list(), from text. @param directory  of the list @param name  of the file, for messages
std::vector<FieldEntry> parse_field_list(std::string_view text, const std::filesystem::path& directory,
                                         const std::string& name);

/// An array of values at the points.
struct FieldArray {
  std::string name;  ///< as in the file: "von_mises [MPa]"
  int components = 1;
  std::vector<std::string> component_names = {};  ///< empty, or one per component
};

/// One .vtu file.
class FieldFile {
 public:
  /// Cost: reading the file. @throws ModelError naming the file if it cannot be read or is not a .vtu
  explicit FieldFile(const std::filesystem::path& path);
  /// Reads from text. @param name  of the file, for messages
  FieldFile(std::string text, std::string name);
  ~FieldFile();
  FieldFile(FieldFile&&) noexcept;
  FieldFile& operator=(FieldFile&&) noexcept;

  std::size_t n_points() const;
  std::size_t n_cells() const;
  /// Points, cells and texts. Consecutive cells of one type are a block. @throws ModelError if they are damaged, of a
  /// type that the program does not write, or refer to points that do not exist
  FieldMesh mesh() const;
  std::vector<FieldArray> point_arrays() const;
  /// n_points x components, row by row. @throws ModelError if there is no such array or it is damaged
  std::vector<double> point_values(const std::string& name) const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
};

}  // namespace creepcontact::io
