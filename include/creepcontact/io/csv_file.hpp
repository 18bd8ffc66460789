#pragma once
/// CSV tables on disk that are complete up to the last row at any time; used for history.csv and steps.csv.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

/// Whether a writer starts a new file or continues that of an interrupted run.
struct Continuation {
  bool resume = false;
  /// Rows (field files) of later times are removed; new ones follow after them.
  double last_time = 0;
};

/// Comma-separated text with the time in the first column. Each row is passed to the system as it is written.
class CsvFile {
 public:
  /// Starts a new file. When resuming, keeps the rows up to `last_time` (an incomplete last row is dropped) and appends
  /// to them; a missing file is started again. Makes the directory if necessary.
  /// @throws ConfigError if the file cannot be opened, or has columns other than `columns` when resuming
  CsvFile(const std::filesystem::path& path, const std::vector<std::string>& columns, Continuation continuation);

  /// @param row  cells separated by commas, without end of line
  /// @throws Error if the disk cannot take the row
  void write(std::string_view row);
  /// Waits until all rows are on disk. @throws Error if the disk cannot take them
  void sync();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace creepcontact::io
