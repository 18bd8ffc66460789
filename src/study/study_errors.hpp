#pragma once
/// Errors of a run's history against the reference of its study.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"
#include "creepcontact/io/tables/csv_table.hpp"

namespace creepcontact::study {

/// The reference as values at times, or as functions of time.
class ReferenceHistory {
 public:
  /// @param name  of the reference in messages
  /// @throws ConfigError if the table lacks `time` or a quantity
  ReferenceHistory(io::CsvTable table, std::string name, const std::vector<config::Reference>& quantities);
  /// Taken at the output times of the run itself.
  explicit ReferenceHistory(std::map<std::string, Function> expressions) : expressions_(std::move(expressions)) {}

  struct Error {
    double value;         ///< NaN if it is not known ...
    std::string message;  ///< ... and why
  };
  /// |run - reference| at the reference's output times, the largest or the last, divided by the largest magnitude that
  /// the reference has (max) or by its last one (final). A run that ended early (`whole` is false) is compared up to
  /// its end with max, and has no error with final.
  Error error(const io::CsvTable& history, const std::string& quantity, config::ErrorNorm norm, bool whole) const;

 private:
  struct Points {
    std::vector<double> times, values;
  };
  Points points(const std::string& quantity, const std::vector<double>& run_times) const;

  io::CsvTable table_;
  std::map<std::string, Function> expressions_;
};

}  // namespace creepcontact::study
