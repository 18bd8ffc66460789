#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/directory_lock.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "shard_store.hpp"
#include "shards.hpp"
#include "shell_text.hpp"
#include "study_conclusion.hpp"
#include "study_directory.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_named = 10;

/// What the directory of a run holds, if it was made for this study as it is.
RunOutcome outcome_in(const fs::path& directory, const std::string& record) {
  RunOutcome missing;
  missing.row.status = "not started";
  return file_text(directory / record_file) == record ? found_outcome(directory) : missing;
}

std::string some_of(const std::vector<std::string>& names) {
  const std::vector<std::string> first(names.begin(), names.begin() + std::min(most_named, names.size()));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     names.size() > most_named ? fmt::format(" and {} more", names.size() - most_named) : "");
}

/// Commands that make what is missing.
std::string remedy(const fs::path& file, const fs::path& directory, const std::set<int>& shards,
                   std::optional<int> count) {
  std::string command =
      fmt::format("creepcontact study {} --output {}", shell_quoted(file.string()), shell_quoted(directory.string()));
  if (!count) return command;
  std::vector<std::string> names;
  names.reserve(shards.size());
  for (const int shard : shards) names.push_back(std::to_string(shard));
  return fmt::format("{} --shard i/{} with i = {}", command, *count, some_of(names));
}

}  // namespace

StudyResult gather_study(const config::Study& given, const config::Vocabulary& vocabulary,
                         const StudyOptions& options) {
  config::Study study = given;
  study.compare.quantities = config::compared_probes(given, vocabulary);
  const std::vector<config::PlannedRun> runs = config::plan(study);
  const fs::path directory = directory_of(study, options);
  if (!path_exists(directory / stored_study))
    throw ConfigError(fmt::format("nothing to gather: '{}' is not the directory of a study; run its shards first",
                                  directory.string()));
  const platform::Interrupt interrupt;
  const platform::DirectoryLock lock(directory);
  claim_directory(directory, study);
  StudyConclusion conclusion(study, runs, result_units(study, vocabulary, options));
  RunRecords records(study, vocabulary);
  std::vector<std::string> missing, failed;
  std::set<int> shards;
  const auto reference = config::reference_run(study);
  if (reference) {
    const fs::path place = directory / "runs" / reference->name;
    if (const RunOutcome outcome = outcome_in(place, records.of(*reference)); outcome.row.succeeded()) {
      conclusion.take_reference(outcome, (place / "history.csv").string());
    } else {
      missing.push_back(reference->name);
      shards.insert(1);
    }
  }
  const std::optional<int> count = shard_count(directory);
  // Shard by shard, so that one file at a time is in memory.
  for (int shard = 1; shard <= count.value_or(1); ++shard) {
    ShardStore store(study, vocabulary, shard_file(directory, shard));
    for (const std::size_t run : runs_of_shard(runs.size(), {shard, count.value_or(1)})) {
      const KeptRun* const kept = store.find(run, runs[run]);
      const bool is_kept = kept != nullptr && kept->outcome.row.succeeded();
      const RunOutcome in_directory =
          is_kept ? RunOutcome{} : outcome_in(directory / "runs" / runs[run].name, records.of(runs[run]));
      const RunOutcome& outcome =
          is_kept || (kept != nullptr && !in_directory.row.succeeded()) ? kept->outcome : in_directory;
      conclusion.take(run, outcome);
      if (outcome.row.succeeded()) continue;
      const bool has_failed = outcome.row.status == "failed";
      (has_failed ? failed : missing).push_back(runs[run].name);
      shards.insert(shard);
    }
    if (interrupt.requested()) return {platform::interrupted_status, "interrupted: nothing was written"};
  }
  conclusion.write(directory);
  const std::size_t succeeded =
      runs.size() - failed.size() - missing.size() + (reference && std::ranges::count(missing, "reference") ? 1 : 0);
  if (!failed.empty())
    log::warning("{} runs failed: {}; study.csv says why; made again by {}", failed.size(), some_of(failed),
                 remedy(study.file, directory, shards, count));
  std::string text = fmt::format("{} of {} runs succeeded; results in {}", succeeded, runs.size(), directory.string());
  if (missing.empty() && succeeded > 0) return {0, text};
  if (!missing.empty())
    text += fmt::format("; {} are missing: {}; made by {}", missing.size(), some_of(missing),
                        remedy(study.file, directory, shards, count));
  return {SolverError::status, text};
}

}  // namespace creepcontact::study
