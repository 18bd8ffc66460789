#pragma once
/// The runs of a study, side by side: as processes, or as threads of this one.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"
#include "creepcontact/config/vocabulary.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/study/study.hpp"
#include "run_records.hpp"
#include "study_progress.hpp"
#include "study_results.hpp"

namespace creepcontact::study {

class StudyExecution {
 public:
  /// @param directory  of the study; all are referred to and must outlive this
  StudyExecution(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options,
                 const std::filesystem::path& directory, const platform::Interrupt& interrupt, StudyProgress& progress);

  /// Makes the runs that are not finished yet; after an interruption the rest is "not started".
  /// @returns one row per run, without errors
  std::vector<StudyRow> run(const std::vector<config::PlannedRun>& runs);
  std::filesystem::path directory_of(const config::PlannedRun& run) const { return directory_ / "runs" / run.name; }

 private:
  /// What is to be computed of a run. @returns nullopt if it is finished, and its row
  std::optional<RunCall> prepare(const config::PlannedRun& run, StudyRow& row);
  void finish(const config::PlannedRun& run, int exit_status, StudyRow& row);
  void run_in_processes(const std::vector<config::PlannedRun>& runs, std::vector<StudyRow>& rows);
  void run_together(const std::vector<config::PlannedRun>& runs, std::vector<StudyRow>& rows);
  std::vector<std::string> arguments_of(const RunCall& call) const;

  const config::Study& study_;
  RunRecords records_;
  const StudyOptions& options_;
  const std::filesystem::path& directory_;
  std::size_t jobs_;  // runs at a time, among which the cores are divided
  const platform::Interrupt& interrupt_;
  StudyProgress& progress_;
};

}  // namespace creepcontact::study
