#pragma once
/// From the outcomes of the runs to the tables and pictures of a study.

#include <filesystem>
#include <optional>
#include <vector>

#include "comparison.hpp"
#include "histories.hpp"
#include "result_units.hpp"

namespace creepcontact::study {

/// Takes the outcomes one by one, so that not all have to be in memory.
class StudyConclusion {
 public:
  /// @param study  with the compared probes; it and the runs are referred to and must outlive this
  StudyConclusion(const config::Study& study, const std::vector<config::PlannedRun>& runs, ResultUnits units);

  void take_reference(const RunOutcome& outcome, const std::string& name);
  /// @param row  of the run, if it is not that of the outcome
  void take(std::size_t run, const RunOutcome& outcome, StudyRow row);
  void take(std::size_t run, const RunOutcome& outcome) { take(run, outcome, outcome.row); }

  /// Writes study.csv, study.md, pictures, and with random keys their tables.
  void write(const std::filesystem::path& directory) const;

  /// In the order of the runs; "not started": not taken.
  const std::vector<StudyRow>& rows() const { return rows_; }

 private:
  const config::Study& study_;
  const std::vector<config::PlannedRun>& runs_;
  Comparison comparison_;
  std::optional<StudyRow> reference_;
  std::vector<StudyRow> rows_;
  Histories histories_;
  ResultUnits units_;
};

}  // namespace creepcontact::study
