#include "study_execution.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <thread>

#include "creepcontact/base/cores.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/platform/child_process.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "run_outcome.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;
using Status = io::Summary::Status;

constexpr auto between_looks = std::chrono::milliseconds(10);

/// @param log  file for what the program prints, replaced
platform::ChildProcess start_logged(const fs::path& program, const std::vector<std::string>& arguments,
                                    const fs::path& log) {
  struct File {
    int descriptor;
    ~File() { ::close(descriptor); }
  };
  const File file{platform::create_file(log)};
  return platform::ChildProcess({program,
                                 arguments,
                                 {{file.descriptor, STDOUT_FILENO}, {file.descriptor, STDERR_FILENO}},
                                 SIGTERM,
                                 /*lets_signals_through=*/true});
}

/// The directory is that of a run, in "runs", in that of the study.
void make_empty(const fs::path& directory) {
  std::error_code error;
  fs::remove_all(directory, error);
  if (!error) platform::make_inner_directory(directory);
  if (error) throw ConfigError(fmt::format("directory of a run '{}': {}", directory.string(), error.message()));
}

std::string settings_text(const config::Study& study, const config::PlannedRun& run) {
  std::string text;
  for (const config::Setting& setting : config::settings_of(study, run))
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", setting.key, setting.value.label);
  return text;
}

/// Whether the interrupted run of this directory can go on.
bool resumable(const fs::path& directory) {
  const auto summary = io::read_summary(directory / "summary.json");
  return summary && summary->status == Status::interrupted && path_exists(directory / "checkpoint.h5");
}

}  // namespace

StudyExecution::StudyExecution(const config::Study& study, const config::Vocabulary& vocabulary,
                               const StudyOptions& options, const fs::path& directory,
                               const platform::Interrupt& interrupt, StudyProgress& progress)
    : study_(study),
      records_(study, vocabulary),
      options_(options),
      directory_(directory),
      jobs_(static_cast<std::size_t>(options.jobs > 0 ? options.jobs : cores())),
      interrupt_(interrupt),
      progress_(progress) {}

std::vector<StudyRow> StudyExecution::run(const std::vector<config::PlannedRun>& runs) {
  StudyRow not_started;
  not_started.status = "not started";
  std::vector<StudyRow> rows(runs.size(), not_started);
  const bool is_together = study_.random && options_.make_together && options_.together > 1 && runs.size() > 1;
  is_together ? run_together(runs, rows) : run_in_processes(runs, rows);
  return rows;
}

std::optional<RunCall> StudyExecution::prepare(const config::PlannedRun& run, StudyRow& row) {
  const fs::path directory = directory_of(run);
  platform::make_inner_directory(directory.parent_path());
  platform::make_inner_directory(directory);
  const std::string record = records_.of(run);
  const bool same = file_text(directory / record_file) == record;
  if (StudyRow found = same ? finished_outcome(directory).row : StudyRow{}; found.succeeded()) {
    progress_.kept(found);
    row = found;
    return std::nullopt;
  }
  RunCall call{.base = study_.base,
               .overrides = config::overrides(study_, run),
               .output = directory,
               .log = directory / log_file,
               .resume = same && resumable(directory),
               .trust_geometry = options_.trust_geometry};
  if (!call.resume) {
    // The summary of other settings must not speak for these, should the run be killed at once.
    make_empty(directory);
    platform::replace_file(directory / record_file, record);
  }
  return call;
}

void StudyExecution::finish(const config::PlannedRun& run, int exit_status, StudyRow& row) {
  row = ended_row(directory_of(run), exit_status);
  progress_.finished(run.name, settings_text(study_, run), row);
}

std::vector<std::string> StudyExecution::arguments_of(const RunCall& call) const {
  std::vector<std::string> arguments{
      "run",
      call.base.string(),
      "--output",
      call.output.string(),
      "--quiet",
      "--threads",
      std::to_string(std::max<std::size_t>(1, static_cast<std::size_t>(cores()) / jobs_))};
  for (const std::string& one : call.overrides) {
    arguments.emplace_back("--set");
    arguments.push_back(one);
  }
  if (call.trust_geometry) arguments.emplace_back("--trust-geometry");
  if (call.resume) arguments.emplace_back("--resume");
  return arguments;
}

void StudyExecution::run_in_processes(const std::vector<config::PlannedRun>& runs, std::vector<StudyRow>& rows) {
  struct UnderWay {
    std::size_t index;
    platform::ChildProcess process;
    UnderWay(std::size_t i, const fs::path& program, const std::vector<std::string>& arguments, const fs::path& log)
        : index(i), process(start_logged(program, arguments, log)) {}
  };
  std::list<UnderWay> under_way;
  std::size_t next = 0;
  bool told = false;
  while (!under_way.empty() || (next < runs.size() && !told)) {
    if (interrupt_.requested() && !told) {
      for (UnderWay& one : under_way) one.process.interrupt();
      told = true;
    }
    for (; !told && next < runs.size() && under_way.size() < jobs_; ++next)
      if (const auto call = prepare(runs[next], rows[next]))
        under_way.emplace_back(next, options_.program, arguments_of(*call), call->log);
    for (auto one = under_way.begin(); one != under_way.end();) {
      const auto status = one->process.poll();
      if (!status) {
        ++one;
        continue;
      }
      finish(runs[one->index], *status, rows[one->index]);
      one = under_way.erase(one);
    }
    progress_.draw(under_way.size());
    if (!under_way.empty()) std::this_thread::sleep_for(between_looks);
  }
}

void StudyExecution::run_together(const std::vector<config::PlannedRun>& runs, std::vector<StudyRow>& rows) {
  constexpr std::size_t most_prepared = 1000;  // directories made before their runs
  for (std::size_t next = 0; next < runs.size() && !interrupt_.requested();) {
    std::vector<RunCall> calls;
    std::vector<std::size_t> indices;
    for (; next < runs.size() && calls.size() < most_prepared; ++next)
      if (auto call = prepare(runs[next], rows[next])) {
        calls.push_back(std::move(*call));
        indices.push_back(next);
      }
    progress_.draw(std::min(options_.together, calls.size()));
    options_.make_together(calls, options_.together, [&](std::size_t i, int exit_status) {
      finish(runs[indices[i]], exit_status, rows[indices[i]]);
      progress_.draw(options_.together);
    });
  }
}

}  // namespace creepcontact::study
