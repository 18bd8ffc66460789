#pragma once
/// steps.csv: one row per accepted step.

#include <cstdint>

#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/io/tables/csv_file.hpp"

namespace creepcontact::io {

/// One accepted step.
struct StepRow {
  double time = 0;  ///< at the end of the step
  double step = 0;  ///< length of the step
  int order = 0;
  RunCounters work;  ///< of this step
  std::int64_t active_contacts = 0;
  double error_estimate = 0;
};

/// Appends rows to steps.csv, one column per member of StepRow.
class StepWriter {
 public:
  /// @throws ConfigError as CsvFile
  explicit StepWriter(const std::filesystem::path& path, Continuation continuation = {}, CsvFormat format = {});

  /// @throws Error if the disk cannot take the row
  void write(const StepRow& row);
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  CsvFile file_;
};

}  // namespace creepcontact::io
