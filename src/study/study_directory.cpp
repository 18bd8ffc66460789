#include "study_directory.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "run_outcome.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

/// Whether the text is that of the study with another number of samples, which leaves the runs as they are.
bool differs_in_size_alone(const std::string& text, const config::Study& study) {
  try {
    return config::parse_study(text, study.file).without_size == study.without_size;
  } catch (const ConfigError&) {
    return false;
  }
}

/// In one step, whoever else writes it.
void store(const fs::path& file, const std::string& text) {
  fs::path own = file;
  own += fmt::format(".{}", unique_suffix());
  platform::replace_file(own, text);
  std::error_code failure;
  fs::rename(own, file, failure);
  if (failure) throw ConfigError(fmt::format("cannot write '{}': {}", file.string(), failure.message()));
}

}  // namespace

fs::path directory_of(const config::Study& study, const StudyOptions& options) {
  return options.output.empty() ? study.file.parent_path() / "results" / study.file.stem() : options.output;
}

/// Only one study may use a directory: the results of two would get mixed.
void claim_directory(const fs::path& directory, const config::Study& study) {
  std::error_code failure;
  fs::create_directories(directory, failure);
  if (failure) throw ConfigError(fmt::format("output directory {}: {}", directory.string(), failure.message()));
  const fs::path file = directory / stored_study;
  // Asked before the study's file: another shard may begin between the two questions.
  const bool has_runs = path_exists(directory / "runs");
  if (path_exists(file)) {
    const std::string text = file_text(file);
    if (text == study.normalized) return;
    if (differs_in_size_alone(text, study)) return store(file, study.normalized);
    throw ConfigError(
        fmt::format("output directory {} belongs to another study, or to {} before a change (its former text is in "
                    "{}); choose another directory with --output, or remove this one",
                    directory.string(), study.file.string(), file.string()));
  }
  // Runs are made in directories that are emptied before.
  if (has_runs)
    throw ConfigError(fmt::format(
        "output directory {} contains '{}', which was not written by a study; choose another directory with --output",
        directory.string(), (directory / "runs").string()));
  store(file, study.normalized);
}

}  // namespace creepcontact::study
