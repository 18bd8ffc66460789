#pragma once
/// Reading of CSV tables with a header: of numbers (history.csv, steps.csv, or a reference in their form), or of any
/// cells.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "creepcontact/base/csv_format.hpp"
#include "creepcontact/io/tables/thousands.hpp"

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

/// The numbers of one file. Its decimal sign is a point or a comma; a file with both is refused, since one of them may
/// separate thousands: 1.000 in a file with 0,010 is a thousand. What separates thousands may be given; then the other
/// one is the decimal sign.
class CsvNumbers {
 public:
  /// @param way_out  how thousands are given, for messages: "--thousands"; empty: they cannot be
  CsvNumbers(CsvFormat format, Thousands thousands, std::string way_out)
      : format_(format), thousands_(thousands), way_out_(std::move(way_out)) {}

  /// A number, or why the cell is none in this file: with the cause and the way out.
  struct Reading {
    std::optional<double> value;
    std::string mistake;  ///< empty with a value
  };
  /// @param line  of the cell, for messages
  Reading read(const std::string& cell, std::size_t line);

 private:
  struct Sight {
    std::string cell;
    std::size_t line = 0;  // 0: none yet
  };
  std::string way_out(char thousands) const;

  CsvFormat format_;
  Thousands thousands_;
  std::string way_out_;
  Sight with_point_, with_comma_;  // the first of each kind
};

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

/// Parses as parse_csv_table(), but without a demand on the cells; lines that begin with '#' are comments.
/// @param name  of the file, for messages @throws ConfigError if there is no header
CsvCells parse_csv_cells(std::string_view text, const std::string& name);

/// The number that is the whole of `cell`; a point is understood as decimal in every format. Tables are read by
/// CsvNumbers, which notices where formats are mixed.
std::optional<double> csv_number(std::string_view cell, const CsvFormat& format);

/// Text as a CSV cell: quoted if it contains characters with a meaning in the format (RFC 4180).
std::string csv_cell(const std::string& text, CsvFormat format = {});

}  // namespace creepcontact::io
