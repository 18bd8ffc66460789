#pragma once
/// Fills what the outcomes of runs alone do not tell: the courses of their probes, and errors against the reference.

#include <filesystem>
#include <optional>

#include "run_outcome.hpp"
#include "study_errors.hpp"

namespace creepcontact::study {

class Comparison {
 public:
  /// @param study  referred to, must outlive this @throws ConfigError if the file of the reference cannot be read
  explicit Comparison(const config::Study& study);

  /// Compares with this run from now on.
  void take_reference(const RunOutcome& outcome, const std::string& name);

  /// Fills the courses and the errors of a row, and its message where there are none.
  /// @param row  that of the outcome, or another one of the same run
  void compare(const RunOutcome& outcome, StudyRow& row) const;

 private:
  const config::Study& study_;
  std::optional<ReferenceHistory> reference_;
};

}  // namespace creepcontact::study
