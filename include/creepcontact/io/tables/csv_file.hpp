#pragma once
/// CSV tables on disk that are complete up to the last row at any time; used for history.csv and steps.csv.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "creepcontact/base/csv_format.hpp"

namespace creepcontact::io {

/// Whether a writer starts a new file or continues that of an interrupted run.
struct Continuation {
  bool resume = false;
  /// Rows (field files) of later times are removed; new ones follow after them.
  double last_time = 0;
};

/// A number, with the fewest digits that read back to the same double, or a word.
using CsvCell = std::variant<double, std::int64_t, std::string_view>;

/// A table with the time in the first column. Each row is passed to the system as it is written.
class CsvFile {
 public:
  /// Starts a new file. When resuming, keeps the rows up to `last_time` (an incomplete last row is dropped) and appends
  /// to them; a missing file is started again. Makes the directory if necessary.
  /// @throws ConfigError if the file cannot be opened, or has other columns or another format when resuming
  CsvFile(const std::filesystem::path& path, const std::vector<std::string>& columns, Continuation continuation,
          CsvFormat format);

  /// @param row  one cell per column @throws Error if the disk cannot take the row
  void write(std::span<const CsvCell> row);
  /// The file for platform::sync_files(), which makes the rows safe from a power cut.
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void write_line(std::string_view line);

  std::filesystem::path path_;
  CsvFormat format_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string line_;  // to be written
};

}  // namespace creepcontact::io
