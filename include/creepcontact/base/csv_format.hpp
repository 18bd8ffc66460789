#pragma once
/// How the cells of a CSV file are told apart, and how its numbers are written.

namespace creepcontact {

/// Spreadsheets in many languages read files with ';' between the cells and a decimal comma.
struct CsvFormat {
  char separator = ',';  ///< ',', ';' or a tab
  char decimal = '.';    ///< '.' or, unless it separates, ','
  bool operator==(const CsvFormat&) const = default;
};

}  // namespace creepcontact
