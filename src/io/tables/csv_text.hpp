#pragma once
/// Text of comma-separated values in lines and cells.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/base/csv_format.hpp"

namespace creepcontact::io {

/// Hands out the lines of a text, without their ends.
class CsvLines {
 public:
  /// A byte order mark, which spreadsheets write first, is skipped.
  explicit CsvLines(std::string_view text);

  /// @returns false after the last line
  bool next(std::string_view& line);
  /// Whether the line handed out last had an end.
  bool ended() const { return ended_; }

 private:
  std::string_view rest_;
  bool ended_ = true;
};

/// What separates the cells of a file is the first separator of its header, outside of quotes. A decimal comma is
/// possible wherever commas do not separate.
CsvFormat csv_format_of(std::string_view header);

/// Cells of a line, without the blanks around them; those in quotes (RFC 4180) may hold separators.
std::vector<std::string> csv_cells(std::string_view line, char separator);

}  // namespace creepcontact::io
