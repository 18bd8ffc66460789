#pragma once
/// Tables of numbers with a header read back: history.csv and steps.csv, or a reference in their form. Cells of text.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< one a name, all of the same length

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// Null if there is none of this name.
  const std::vector<double>* column(const std::string& name) const;
};

/// Whether a last row without its end of line counts: other programs write such, a run at work leaves torn ones.
enum class UnendedRow { counts, is_left_out };

/// Names may stand in quotes (RFC 4180); blanks around cells and empty lines count for nothing.
/// @throws ConfigError naming the file, and the line and what was found in it: a file that cannot be read, a row with
/// another number of cells than the header, a cell that is no number
CsvTable read_csv_table(const std::filesystem::path& path, UnendedRow unended = UnendedRow::counts);

/// As read_csv_table(), from the text of a file. @param name  of the file, for messages
CsvTable parse_csv_table(std::string_view text, const std::string& name, UnendedRow unended = UnendedRow::counts);

/// A text as a cell: with signs that mean something in the format it stands in quotes (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace creepcontact::io
