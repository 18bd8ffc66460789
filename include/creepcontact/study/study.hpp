#pragma once
/// Makes the runs of a study, compares them with its reference, and writes study.csv and study.md.

#include <filesystem>
#include <string>

#include "creepcontact/config/study.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::study {

struct StudyOptions {
  std::filesystem::path program;  ///< that makes a run: `program run CONFIG.toml ...`
  std::filesystem::path output;   ///< directory; empty: results/<name of the study> beside its file
  int jobs = 0;                   ///< runs at a time; 0: as many as there are cores
  bool trust_geometry = false;    ///< let .geo files run programs and write files
};

struct StudyResult {
  int exit_status = 0;  ///< 4 without one successful run, 130 interrupted
  std::string message;
};

/// Every run is a process of its own, with one thread, in <output>/runs/<name>. Runs that an earlier call has finished
/// with the same settings, files and version are kept, interrupted ones go on from their checkpoint. SIGINT and SIGTERM
/// end the runs under way, each with a checkpoint.
/// @param vocabulary  names that the configurations of the runs may use
/// @throws ConfigError for every mistake that shows beforehand, and if the directory holds another study
/// @throws SolverError if the reference does not come to its end
StudyResult run_study(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options);

}  // namespace creepcontact::study
