#pragma once
/// Tables on disk that are complete up to the last row at any time: the base of history.csv and steps.csv.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io {

/// Whether a writer begins anew or goes on with the file of an interrupted run.
struct Continuation {
  bool resume = false;
  /// Rows (field files) of later times are removed; the next one is written after them.
  double last_time = 0;
};

/// Comma-separated text, first column the time; every row is handed to the system as it is written.
class CsvFile {
 public:
  /// Begins a new file, or, resuming, keeps the rows up to `last_time` (a torn last row is dropped) and appends. A file
  /// that is missing when resuming is begun anew. The directory is made if need be.
  /// @throws ConfigError if the file cannot be opened, or its columns are others than `columns` when resuming
  CsvFile(const std::filesystem::path& path, const std::vector<std::string>& columns, Continuation continuation);

  /// @param row  cells separated by commas, without the end of line
  /// @throws Error if the disk does not take the row
  void write(std::string_view row);
  /// Waits until all rows are on the disk itself. @throws Error if it does not take them
  void sync();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace creepcontact::io
