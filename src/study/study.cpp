#include "creepcontact/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/directory_lock.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "shard_store.hpp"
#include "shards.hpp"
#include "study_conclusion.hpp"
#include "study_directory.hpp"
#include "study_execution.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t runs_before_writing = 200;  // that a kill of the shard leaves in directories of their own

StudyResult result_of(const std::vector<StudyRow>& rows, const platform::Interrupt& interrupt,
                      const fs::path& directory) {
  if (rows.empty()) return {0, "nothing to do: the study has fewer runs than shards"};
  const auto succeeded = std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) { return row.succeeded(); });
  const std::string results =
      fmt::format("{} of {} runs succeeded; results in {}", succeeded, rows.size(), directory.string());
  if (interrupt.requested())
    return {platform::interrupted_status, fmt::format("interrupted: {}; run the same command to continue", results)};
  if (succeeded > 0) return {0, results};
  const auto told = std::find_if(rows.begin(), rows.end(), [](const StudyRow& row) { return !row.message.empty(); });
  return {4, fmt::format("{}{}", results, told != rows.end() ? "; the first one: " + told->message : "")};
}

/// The study with the probes that it is about.
config::Study with_probes(config::Study study, const config::Vocabulary& vocabulary) {
  study.compare.quantities = config::compared_probes(study, vocabulary);
  return study;
}

/// Makes the run with which the others are compared, unless it is finished.
/// @returns nullopt if it was interrupted @throws SolverError if it does not finish
std::optional<RunOutcome> made_reference(StudyExecution& execution, const config::PlannedRun& run,
                                         const platform::Interrupt& interrupt) {
  const StudyRow row = execution.run({run}).front();
  const fs::path directory = execution.directory_of(run);
  if (row.succeeded()) return finished_outcome(directory);
  if (interrupt.requested()) return std::nullopt;
  throw SolverError(fmt::format("the reference {}: {}; its output is in {}", row.status, row.message,
                                (directory / log_file).string()));
}

/// Runs in the files of shards would be made again. @throws ConfigError
void refuse_shard_files(const config::Study& study, const fs::path& directory) {
  const std::optional<int> count = shard_count(directory);
  for (int shard = 1; shard <= count.value_or(0); ++shard)
    if (path_exists(shard_file(directory, shard)))
      throw ConfigError(fmt::format(
          "'{0}' has runs in the files of its {1} shards, which this command would make again; make those that are "
          "missing by `creepcontact study {2} --shard i/{1}` and the tables by --gather, or give another --output",
          directory.string(), *count, study.file.string()));
}

}  // namespace

StudyResult run_study(const config::Study& given, const config::Vocabulary& vocabulary, const StudyOptions& options) {
  const std::vector<config::PlannedRun> runs = config::plan(given);
  config::check_runs(given, runs, vocabulary);
  const config::Study study = with_probes(given, vocabulary);
  StudyConclusion conclusion(study, runs, result_units(study, vocabulary, options));
  const fs::path directory = directory_of(study, options);
  const platform::Interrupt interrupt;  // from here on there is something to save
  std::error_code failure;
  fs::create_directories(directory, failure);
  if (failure) throw ConfigError(fmt::format("output directory {}: {}", directory.string(), failure.message()));
  const platform::DirectoryLock lock(directory);
  claim_directory(directory, study);
  refuse_shard_files(study, directory);

  const auto reference = config::reference_run(study);
  {
    StudyProgress progress(runs.size() + (reference ? 1 : 0));
    StudyExecution execution(study, vocabulary, options, directory, interrupt, progress);
    if (reference)
      if (const auto outcome = made_reference(execution, *reference, interrupt))
        conclusion.take_reference(*outcome, (execution.directory_of(*reference) / "history.csv").string());
    const std::vector<StudyRow> rows = execution.run(runs);
    for (std::size_t r = 0; r < runs.size(); ++r)
      conclusion.take(r, rows[r].succeeded() ? finished_outcome(execution.directory_of(runs[r])) : RunOutcome{},
                      rows[r]);
  }
  conclusion.write(directory);
  return result_of(conclusion.rows(), interrupt, directory);
}

StudyResult run_single(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options,
                       const std::string& name) {
  std::optional<config::PlannedRun> run = config::reference_run(study);
  if (name != "reference") {
    const std::vector<config::PlannedRun> runs = config::plan(study);
    const auto found = std::ranges::find(runs, name, &config::PlannedRun::name);
    run = found == runs.end() ? std::nullopt : std::optional(*found);
    if (!run)
      throw ConfigError(fmt::format("--run: '{}' is not a run of this study; allowed: {} to {}{}", name,
                                    runs.front().name, runs.back().name,
                                    config::reference_run(study) ? ", reference" : ""));
  }
  if (!run) throw ConfigError("--run: the reference of this study is not a run");
  const fs::path directory = directory_of(study, options);
  const platform::Interrupt interrupt;
  claim_directory(directory, study);
  StudyProgress progress(1);
  StudyExecution execution(study, vocabulary, options, directory, interrupt, progress);
  const StudyRow row = execution.run({*run}).front();
  if (interrupt.requested() && !row.succeeded())
    return {platform::interrupted_status, fmt::format("{} interrupted; run the same command to continue", name)};
  return {row.succeeded() ? 0 : SolverError::status,
          fmt::format("{} {}{}; results in {}", name, row.status, row.message.empty() ? "" : ": " + row.message,
                      execution.directory_of(*run).string())};
}

StudyResult run_shard(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options,
                      const Shard& shard) {
  const std::vector<config::PlannedRun> all = config::plan(study);
  config::check_runs(study, all, vocabulary);
  const fs::path directory = directory_of(study, options);
  const platform::Interrupt interrupt;
  claim_directory(directory, study);
  claim_shard_count(directory, shard.count);
  const fs::path own = shard_directory(directory, shard.number);
  platform::make_inner_directory(own);
  const platform::DirectoryLock lock(own);

  std::vector<std::size_t> indices = runs_of_shard(all.size(), shard);
  const auto reference = shard.number == 1 ? config::reference_run(study) : std::nullopt;
  StudyProgress progress(indices.size() + (reference ? 1 : 0));
  StudyExecution execution(study, vocabulary, options, directory, interrupt, progress);
  if (reference) made_reference(execution, *reference, interrupt);
  ShardStore store(study, vocabulary, shard_file(directory, shard.number));
  std::vector<StudyRow> rows;
  const bool is_one_file = study.keep == config::Keep::shard;
  std::erase_if(indices, [&](std::size_t run) {
    const KeptRun* const kept = store.find(run, all[run]);
    if (kept == nullptr || !kept->outcome.row.succeeded()) return false;
    rows.push_back(kept->outcome.row);
    progress.kept(rows.back());
    return true;
  });
  const std::size_t batch = is_one_file ? runs_before_writing : std::max<std::size_t>(1, indices.size());
  for (std::size_t begin = 0; begin < indices.size() && !interrupt.requested(); begin += batch) {
    std::vector<config::PlannedRun> some;
    for (std::size_t i = begin; i < std::min(begin + batch, indices.size()); ++i) some.push_back(all[indices[i]]);
    const std::vector<StudyRow> made = execution.run(some);
    rows.insert(rows.end(), made.begin(), made.end());
    if (!is_one_file) continue;
    for (std::size_t i = 0; i < some.size(); ++i)
      store.take(indices[begin + i], some[i], execution.directory_of(some[i]));
    store.write();  // before their directories go
    for (std::size_t i = 0; i < some.size(); ++i)
      if (made[i].succeeded()) remove_directory(execution.directory_of(some[i]));
  }
  rows.resize(std::max(rows.size(), runs_of_shard(all.size(), shard).size()));
  return result_of(rows, interrupt, own);
}

}  // namespace creepcontact::study
