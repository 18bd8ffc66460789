#pragma once
/// What a run came to, from the files that it left.

#include <filesystem>
#include <map>
#include <string>

#include "creepcontact/io/tables/csv_table.hpp"
#include "study_results.hpp"

namespace creepcontact::study {

inline constexpr const char* log_file = "run.log";
inline constexpr const char* record_file = "settings.txt";

/// All that the tables of a study need of a run.
struct RunOutcome {
  StudyRow row;  ///< without errors and courses
  io::CsvTable history;
  std::map<std::string, ProbeCourse> extremes = {};  ///< by probe, between output times too
};

/// Tells files of this process apart from those of others, on other machines too.
std::string unique_suffix();
/// The file's text; empty if it cannot be read.
std::string file_text(const std::filesystem::path& file);

/// @returns a row without status unless the run came to its end
RunOutcome finished_outcome(const std::filesystem::path& directory);
/// @param exit_status  of the program
StudyRow ended_row(const std::filesystem::path& directory, int exit_status);
/// The outcome of a run that another process started: "failed" if its log says why, "not started" if nothing tells.
RunOutcome found_outcome(const std::filesystem::path& directory);

}  // namespace creepcontact::study
