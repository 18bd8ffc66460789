#pragma once
/// steps.csv: one row per accepted step.

#include <cstdint>

#include "creepcontact/io/csv_file.hpp"

namespace creepcontact::io {

/// One accepted step; the counts are those of this step.
struct StepRow {
  double time = 0;  ///< at its end
  double step = 0;  ///< its length
  int order = 0;
  std::int64_t rhs_evaluations = 0;
  std::int64_t elastic_solves = 0;
  std::int64_t schwarz_iterations = 0;
  std::int64_t active_contacts = 0;
  double error_estimate = 0;
};

class StepWriter {
 public:
  /// @throws ConfigError  as CsvFile
  explicit StepWriter(const std::filesystem::path& path, Continuation continuation = {});

  /// @throws Error if the disk does not take the row
  void write(const StepRow& row);
  void sync() { file_.sync(); }

 private:
  CsvFile file_;
};

}  // namespace creepcontact::io
