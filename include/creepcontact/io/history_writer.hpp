#pragma once
/// history.csv: the values of the probes at every output time.

#include <span>

#include "creepcontact/io/csv_file.hpp"

namespace creepcontact::io {

/// Columns `time,<probe names>`; numbers are written with the fewest digits that read back to the same double.
class HistoryWriter {
 public:
  /// @throws ConfigError as CsvFile
  HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& probes,
                Continuation continuation = {});

  /// @param values  one per probe, in the order of the names @throws Error if the disk cannot take the row
  void write(double time, std::span<const double> values);
  void sync() { file_.sync(); }

 private:
  CsvFile file_;
  std::string row_;
};

}  // namespace creepcontact::io
