#include "study_execution.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <list>
#include <thread>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/io/tables/csv_table.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/io/temperatures/temperature_reader.hpp"
#include "creepcontact/platform/child_process.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;
using Status = io::Summary::Status;

constexpr auto between_looks = std::chrono::milliseconds(10);
const char* const log_file = "run.log";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return stream ? std::string(std::istreambuf_iterator<char>(stream), {}) : "";
}

std::string checksum_line(const fs::path& file) {
  const std::string text = text_of(file);
  Checksum checksum;
  checksum.add(text.data(), text.size());
  return fmt::format("{} {:016x}\n", file.filename().string(), checksum.value());
}

std::string settings_text(const config::PlannedRun& run) {
  std::string text;
  for (const config::Setting& setting : run.settings)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", setting.key, setting.value.label);
  return text;
}

void take_counts(const io::Summary& summary, StudyRow& row) {
  row.counted = true;
  static_cast<RunCounters&>(row) = summary;
  row.wall_seconds = summary.wall_seconds.total;
  for (const auto& [name, criterion] : summary.criteria)
    row.criteria[name] = criterion.met ? criterion.utilisation : ProbeCourse::unknown;
  for (const auto& [name, time] : summary.events) row.events[name] = time.value_or(ProbeCourse::unknown);
}

/// Lines of a run's log that begin so, without their beginning.
std::vector<std::string> logged(const fs::path& directory, const std::string& begin) {
  std::ifstream log(directory / log_file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(log, line);)
    if (line.starts_with(begin)) lines.push_back(line.substr(begin.size()));
  return lines;
}

bool has_history(const fs::path& directory) {
  try {
    return io::read_csv_table(directory / "history.csv").rows() > 0;
  } catch (const ConfigError&) {
    return false;
  }
}

/// @returns a row without status unless the run came to its end
StudyRow finished_row(const fs::path& directory) {
  StudyRow row;
  const auto summary = io::read_summary(directory / "summary.json");
  if (!summary || (summary->status != Status::completed && summary->status != Status::ruptured)) return row;
  if (!has_history(directory)) return row;
  take_counts(*summary, row);
  row.status = summary->status == Status::ruptured ? "ruptured" : "completed";
  const std::vector<std::string> warnings = logged(directory, "warning: ");
  if (!warnings.empty()) row.message = "warning: " + warnings.front();
  if (warnings.size() > 1) row.message += fmt::format(" (and {} more in {})", warnings.size() - 1, log_file);
  return row;
}

/// What the program said at its end.
std::string logged_errors(const fs::path& directory, int exit_status) {
  const std::vector<std::string> errors = logged(directory, "error: ");
  if (!errors.empty()) return fmt::format("{}", fmt::join(errors, "; "));
  return exit_status > 128 ? fmt::format("ended by signal {}", exit_status - 128)
                           : fmt::format("ended with exit status {}", exit_status);
}

StudyRow ended_row(const fs::path& directory, int exit_status) {
  StudyRow row = exit_status == 0 ? finished_row(directory) : StudyRow{};
  if (row.succeeded()) return row;
  if (const auto summary = io::read_summary(directory / "summary.json")) take_counts(*summary, row);
  row.status = exit_status == platform::interrupted_status ? "interrupted" : "failed";
  if (row.status == "failed") row.message = logged_errors(directory, exit_status);
  return row;
}

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

/// The lines of the files of temperatures.
std::string checksum_lines(const std::vector<fs::path>& files) {
  std::string lines;
  try {
    for (const fs::path& file : io::temperature_files({files})) lines += checksum_line(file);
  } catch (const ModelError&) {  // a pattern without files: the run tells
  }
  return lines;
}

/// Whether the interrupted run of this directory can go on.
bool resumable(const fs::path& directory) {
  const auto summary = io::read_summary(directory / "summary.json");
  return summary && summary->status == Status::interrupted && path_exists(directory / "checkpoint.h5");
}

}  // namespace

/// What the results depend on: settings, program, and the files that the configuration names.
std::string StudyExecution::record_of(const config::PlannedRun& run) const {
  const std::vector<std::string> overrides = config::overrides(study_, run.settings);
  const config::Config config = config::read(study_.base, vocabulary_, overrides);
  std::string record = fmt::format("creepcontact {}\n", CREEPCONTACT_VERSION);
  record += checksum_line(study_.base) + checksum_line(config.mesh.file);
  if (config.temperature && !config.temperature->files.empty()) record += checksum_lines(config.temperature->files);
  for (const std::string& one : overrides) record += one + '\n';
  return record;
}

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
    const std::string record = record_of(runs[i]);
    const bool same = text_of(directory / "settings.txt") == record;
    if (StudyRow row = same ? finished_row(directory) : StudyRow{}; row.succeeded()) {
      progress_.kept(row);
      rows[i] = row;
      return;
    }
    std::vector<std::string> arguments{"run",     study_.base.string(), "--output",     directory.string(),
                                       "--quiet", "--threads",          threads_of_run_};
    for (const std::string& one : config::overrides(study_, runs[i].settings)) {
      arguments.emplace_back("--set");
      arguments.push_back(one);
    }
    if (trust_geometry_) arguments.emplace_back("--trust-geometry");
    if (same && resumable(directory)) {
      arguments.emplace_back("--resume");
    } else {
      // The summary of other settings must not speak for these, should the run be killed at once.
      make_empty(directory);
      platform::replace_file(directory / "settings.txt", record);
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
      progress_.finished(run.name, settings_text(run), rows[one->index]);
      one = under_way.erase(one);
    }
    progress_.draw(under_way.size());
    if (!under_way.empty()) std::this_thread::sleep_for(between_looks);
  }
  return rows;
}

}  // namespace creepcontact::study
