#pragma once
/// Tables of numbers read back: history.csv, or a reference in its form.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::io {

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> values;  ///< of every column

  /// Index into columns; their number if there is none of the name.
  std::size_t find(const std::string& column) const;
};

/// @param file  a header, then rows of as many numbers; empty lines count for nothing
/// @throws ConfigError naming file and line if it cannot be read or a cell is no number
CsvTable read_csv(const std::filesystem::path& file);

}  // namespace creepcontact::io
