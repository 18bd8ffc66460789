#pragma once
/// history.csv: the values of the probes at every output time.

#include <span>

#include "creepcontact/io/tables/csv_file.hpp"

namespace creepcontact::io {

/// Columns `time,<probe names>`.
class HistoryWriter {
 public:
  /// @throws ConfigError as CsvFile
  HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& probes,
                Continuation continuation = {}, CsvFormat format = {});

  /// @param values  one per probe, in the order of the names @throws Error if the disk cannot take the row
  void write(double time, std::span<const double> values);
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  CsvFile file_;
  std::vector<CsvCell> row_;
};

}  // namespace creepcontact::io
