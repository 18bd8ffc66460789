#pragma once
/// The runs of a study as processes side by side.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"
#include "creepcontact/config/vocabulary.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "run_records.hpp"
#include "study_progress.hpp"
#include "study_results.hpp"

namespace creepcontact::study {

class StudyExecution {
 public:
  /// @param jobs  runs at a time, among which the cores are divided
  /// @param directory  of the study; all are referred to and must outlive this
  /// @param trust_geometry  passed on to the runs
  StudyExecution(const config::Study& study, const config::Vocabulary& vocabulary, const std::filesystem::path& program,
                 const std::filesystem::path& directory, int jobs, int cores, bool trust_geometry,
                 const platform::Interrupt& interrupt, StudyProgress& progress)
      : study_(study),
        records_(study, vocabulary),
        program_(program),
        directory_(directory),
        jobs_(static_cast<std::size_t>(jobs)),
        threads_of_run_(std::to_string(std::max(1, cores / jobs))),
        trust_geometry_(trust_geometry),
        interrupt_(interrupt),
        progress_(progress) {}

  /// Makes the runs that are not finished yet; after an interruption the rest is "not started".
  /// @returns one row per run, without errors
  std::vector<StudyRow> run(const std::vector<config::PlannedRun>& runs);
  std::filesystem::path directory_of(const config::PlannedRun& run) const { return directory_ / "runs" / run.name; }

 private:
  const config::Study& study_;
  RunRecords records_;
  const std::filesystem::path& program_;
  const std::filesystem::path& directory_;
  std::size_t jobs_;
  std::string threads_of_run_;
  bool trust_geometry_;
  const platform::Interrupt& interrupt_;
  StudyProgress& progress_;
};

}  // namespace creepcontact::study
