#pragma once
/// Text of comma-separated values in lines and cells.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

/// Hands out the lines of a text, without their ends.
class CsvLines {
 public:
  /// A byte order mark, which spreadsheets write first, is passed over.
  explicit CsvLines(std::string_view text);

  /// @returns false after the last line
  bool next(std::string_view& line);
  /// Whether the line handed out last had an end.
  bool ended() const { return ended_; }

 private:
  std::string_view rest_;
  bool ended_ = true;
};

/// Cells of a line, without the blanks around them; those in quotes (RFC 4180) may hold commas.
std::vector<std::string> csv_cells(std::string_view line);

}  // namespace creepcontact::io
