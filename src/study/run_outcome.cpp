#include "run_outcome.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <random>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/platform/interrupt.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;
using Status = io::Summary::Status;

void take_counts(const io::Summary& summary, StudyRow& row) {
  row.counted = true;
  static_cast<RunCounters&>(row) = summary;
  row.wall_seconds = summary.wall_seconds.total;
  row.end_time = summary.time_reached;
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

io::CsvTable history_in(const fs::path& directory) {
  try {
    return io::read_csv_table(directory / "history.csv");
  } catch (const ConfigError&) {
    return {};
  }
}

/// What the program said at its end.
std::string logged_errors(const fs::path& directory, int exit_status) {
  const std::vector<std::string> errors = logged(directory, "error: ");
  if (!errors.empty()) return fmt::format("{}", fmt::join(errors, "; "));
  return exit_status > 128 ? fmt::format("ended by signal {}", exit_status - 128)
                           : fmt::format("ended with exit status {}", exit_status);
}

}  // namespace

std::string unique_suffix() {
  return fmt::format("{}-{:08x}", ::getpid(), std::random_device()());
}

std::string file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return stream ? std::string(std::istreambuf_iterator<char>(stream), {}) : "";
}

RunOutcome finished_outcome(const fs::path& directory) {
  RunOutcome outcome;
  const auto summary = io::read_summary(directory / "summary.json");
  if (!summary || (summary->status != Status::completed && summary->status != Status::ruptured)) return outcome;
  io::CsvTable history = history_in(directory);
  if (history.rows() == 0) return outcome;
  outcome.history = std::move(history);
  take_counts(*summary, outcome.row);
  for (const auto& [name, probe] : summary->probes)
    if (probe.course)
      outcome.extremes[name] = {.start = ProbeCourse::unknown,
                                .end = ProbeCourse::unknown,
                                .min = probe.course->min,
                                .max = probe.course->max};
  outcome.row.status = summary->status == Status::ruptured ? "ruptured" : "completed";
  const std::vector<std::string> warnings = logged(directory, "warning: ");
  if (!warnings.empty()) outcome.row.message = "warning: " + warnings.front();
  if (warnings.size() > 1) outcome.row.message += fmt::format(" (and {} more in {})", warnings.size() - 1, log_file);
  return outcome;
}

StudyRow ended_row(const fs::path& directory, int exit_status) {
  StudyRow row = exit_status == 0 ? finished_outcome(directory).row : StudyRow{};
  if (row.succeeded()) return row;
  if (const auto summary = io::read_summary(directory / "summary.json")) take_counts(*summary, row);
  row.status = exit_status == platform::interrupted_status ? "interrupted" : "failed";
  if (row.status == "failed") row.message = logged_errors(directory, exit_status);
  return row;
}

RunOutcome found_outcome(const fs::path& directory) {
  RunOutcome outcome = finished_outcome(directory);
  if (outcome.row.succeeded()) return outcome;
  const std::vector<std::string> errors = logged(directory, "error: ");
  const auto summary = io::read_summary(directory / "summary.json");
  // Before its first step a run that is ended by a signal leaves no summary, only this message.
  const bool was_interrupted = (summary && summary->status == Status::interrupted) ||
                               (!errors.empty() && errors.back().starts_with("interrupted"));
  outcome.row.status = was_interrupted ? "interrupted" : errors.empty() ? "not started" : "failed";
  if (was_interrupted || errors.empty()) return outcome;
  if (summary) take_counts(*summary, outcome.row);
  outcome.row.message = fmt::format("{}", fmt::join(errors, "; "));
  return outcome;
}

}  // namespace creepcontact::study
