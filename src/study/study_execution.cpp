#include "study_execution.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <list>
#include <thread>

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

std::vector<StudyRow> StudyExecution::run(const std::vector<config::PlannedRun>& runs) {
  struct UnderWay {
    std::size_t index;
    platform::ChildProcess process;
    UnderWay(std::size_t i, const fs::path& program, const std::vector<std::string>& arguments, const fs::path& log)
        : index(i), process(start_logged(program, arguments, log)) {}
  };
  StudyRow not_started;
  not_started.status = "not started";
  std::vector<StudyRow> rows(runs.size(), not_started);
  std::list<UnderWay> under_way;
  std::size_t next = 0;

  const auto start = [&](std::size_t i) {
    const fs::path directory = directory_of(runs[i]);
    platform::make_inner_directory(directory.parent_path());
    platform::make_inner_directory(directory);
    const std::string record = records_.of(runs[i]);
    const bool same = file_text(directory / record_file) == record;
    if (StudyRow row = same ? finished_outcome(directory).row : StudyRow{}; row.succeeded()) {
      progress_.kept(row);
      rows[i] = row;
      return;
    }
    std::vector<std::string> arguments{"run",     study_.base.string(), "--output",     directory.string(),
                                       "--quiet", "--threads",          threads_of_run_};
    for (const std::string& one : config::overrides(study_, runs[i])) {
      arguments.emplace_back("--set");
      arguments.push_back(one);
    }
    if (trust_geometry_) arguments.emplace_back("--trust-geometry");
    if (same && resumable(directory)) {
      arguments.emplace_back("--resume");
    } else {
      // The summary of other settings must not speak for these, should the run be killed at once.
      make_empty(directory);
      platform::replace_file(directory / record_file, record);
    }
    under_way.emplace_back(i, program_, arguments, directory / log_file);
  };

  bool told = false;
  while (!under_way.empty() || (next < runs.size() && !told)) {
    if (interrupt_.requested() && !told) {
      for (UnderWay& one : under_way) one.process.interrupt();
      told = true;
    }
    while (!told && next < runs.size() && under_way.size() < jobs_) start(next++);
    for (auto one = under_way.begin(); one != under_way.end();) {
      const auto status = one->process.poll();
      if (!status) {
        ++one;
        continue;
      }
      const config::PlannedRun& run = runs[one->index];
      rows[one->index] = ended_row(directory_of(run), *status);
      progress_.finished(run.name, settings_text(study_, run), rows[one->index]);
      one = under_way.erase(one);
    }
    progress_.draw(under_way.size());
    if (!under_way.empty()) std::this_thread::sleep_for(between_looks);
  }
  return rows;
}

}  // namespace creepcontact::study
