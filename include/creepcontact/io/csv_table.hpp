#pragma once
/// Reading of CSV tables with a header: of numbers (history.csv, steps.csv, or a reference in their form), or of any
/// cells.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/base/csv_format.hpp"

namespace creepcontact::io {

/// A table of numbers with named columns.
struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< one per name, all of the same length

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// The column of this name; nullptr if there is none.
  const std::vector<double>* column(const std::string& name) const;
};

/// Treatment of a last row without end of line: other programs write such rows, and a run in progress leaves incomplete
/// ones.
enum class UnendedRow { counts, is_left_out };

/// Cells are separated by what follows the first name: a comma, a semicolon or a tab; with the latter two, numbers may
/// have a decimal comma. Names may be quoted (RFC 4180); blanks around cells and empty lines are ignored.
/// @throws ConfigError naming the file, the line and what was found: an unreadable file, a row whose number of cells
/// differs from the header, or a cell that is not a number
CsvTable read_csv_table(const std::filesystem::path& path, UnendedRow unended = UnendedRow::counts);

/// Like read_csv_table(), from text. @param name  name of the file, for messages
CsvTable parse_csv_table(std::string_view text, const std::string& name, UnendedRow unended = UnendedRow::counts);

/// A table of any cells.
struct CsvCells {
  struct Row {
    int line;                        ///< in the file, counted from 1
    std::vector<std::string> cells;  ///< one per name
  };
  struct UnevenRow {
    int line;
    std::size_t cells;
  };
  std::vector<std::string> names;
  std::vector<Row> rows;
  std::vector<UnevenRow> uneven = {};  ///< not among `rows`: more or fewer cells than names
  CsvFormat format;
};

/// As parse_csv_table(), without a demand on the cells; lines that begin with '#' are comments.
/// @param name  of the file, for messages @throws ConfigError if there is no header
CsvCells parse_csv_cells(std::string_view text, const std::string& name);

/// The number that is the whole of `cell`; a point is understood as decimal in every format.
std::optional<double> csv_number(std::string_view cell, const CsvFormat& format);

/// Text as a CSV cell: quoted if it contains characters with a meaning in the format (RFC 4180).
std::string csv_cell(const std::string& text, CsvFormat format = {});

}  // namespace creepcontact::io
