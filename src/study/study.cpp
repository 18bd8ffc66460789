#include "creepcontact/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include "creepcontact/base/cores.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/platform/directory_lock.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "study_errors.hpp"
#include "study_execution.hpp"
#include "study_plots.hpp"
#include "study_report.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

/// Only one study may use a directory: the results of two would get mixed.
void claim(const fs::path& directory, const config::Study& study) {
  const fs::path file = directory / stored_study;
  if (path_exists(file)) {
    std::ifstream stream(file, std::ios::binary);
    if (std::string(std::istreambuf_iterator<char>(stream), {}) == study.normalized) return;
    throw ConfigError(
        fmt::format("output directory {} belongs to another study, or to {} before a change (its former text is in "
                    "{}); choose another directory with --output, or remove this one",
                    directory.string(), study.file.string(), file.string()));
  }
  // Runs are made in directories that are emptied before.
  if (path_exists(directory / "runs"))
    throw ConfigError(fmt::format(
        "output directory {} contains '{}', which was not written by a study; choose another directory with --output",
        directory.string(), (directory / "runs").string()));
  platform::replace_file(file, study.normalized);
}

/// Includes the extremes between output times.
void widen(ProbeCourse& course, const io::SummaryProbe& probe) {
  if (!probe.course || std::isnan(course.min)) return;
  course.min = std::min(course.min, probe.course->min);
  course.max = std::max(course.max, probe.course->max);
}

class Comparison {
 public:
  explicit Comparison(const config::Study& study) : study_(study) {
    if (!study.reference || study.reference->is_run()) return;
    if (study.reference->expressions.empty())
      reference_.emplace(io::read_csv_table(study.reference->csv), study.reference->csv.string(),
                         study.compare.quantities);
    else
      reference_.emplace(study.reference->expressions);
  }

  void take_reference(const fs::path& directory, bool ruptured) {
    const fs::path file = directory / "history.csv";
    io::CsvTable history = io::read_csv_table(file);
    if (ruptured)  // its last row is of the time of rupture, at which no other run has an output
      for (std::vector<double>& column : history.columns) column.pop_back();
    reference_.emplace(std::move(history), file.string(), study_.compare.quantities);
  }

  /// Fills the courses and the errors of a row, and its message where there are none.
  void compare(const fs::path& directory, StudyRow& row) const {
    const std::size_t n = study_.compare.quantities.size();
    row.courses.assign(n, {});
    if (study_.reference) row.errors.assign(n, std::numeric_limits<double>::quiet_NaN());
    if (!row.succeeded() || n == 0) return;
    const io::CsvTable history = io::read_csv_table(directory / "history.csv");
    const auto summary = io::read_summary(directory / "summary.json");
    for (std::size_t q = 0; q < n; ++q) {
      const std::string& name = study_.compare.quantities[q].name;
      row.courses[q] = course_of(*history.column(name));
      if (summary && summary->probes.contains(name)) widen(row.courses[q], summary->probes.at(name));
      if (!reference_) continue;
      const auto [value, message] =
          reference_->error(history, study_.compare.quantities[q].name, study_.compare.norm, row.status == "completed");
      row.errors[q] = value;
      if (!message.empty()) row.message = message + (row.message.empty() ? "" : "; ") + row.message;
    }
  }

 private:
  const config::Study& study_;
  std::optional<ReferenceHistory> reference_;
};

StudyResult result_of(const std::vector<StudyRow>& rows, const platform::Interrupt& interrupt,
                      const fs::path& directory) {
  const auto succeeded = std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) { return row.succeeded(); });
  const std::string results =
      fmt::format("{} of {} runs succeeded; results in {}", succeeded, rows.size(), directory.string());
  if (interrupt.requested())
    return {platform::interrupted_status, fmt::format("interrupted: {}; run the same command to continue", results)};
  if (succeeded > 0) return {0, results};
  const auto told = std::find_if(rows.begin(), rows.end(), [](const StudyRow& row) { return !row.message.empty(); });
  return {4, fmt::format("{}{}", results, told != rows.end() ? "; the first one: " + told->message : "")};
}

/// Results without pictures are better than none.
std::vector<fs::path> drawn(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                            const std::vector<StudyRow>& rows, const fs::path& directory) {
  try {
    return plot_study(study, runs, rows, directory);
  } catch (const Error& error) {
    log::warning("no pictures: {}", error.what());
    return {};
  }
}

}  // namespace

StudyResult run_study(const config::Study& study, const config::Vocabulary& vocabulary, const StudyOptions& options) {
  const std::vector<config::PlannedRun> runs = config::plan(study);
  config::check_runs(study, runs, vocabulary);
  Comparison comparison(study);
  const fs::path directory =
      options.output.empty() ? study.file.parent_path() / "results" / study.file.stem() : options.output;
  const platform::Interrupt interrupt;  // from here on there is something to save
  std::error_code failure;
  fs::create_directories(directory, failure);
  if (failure) throw ConfigError(fmt::format("output directory {}: {}", directory.string(), failure.message()));
  const platform::DirectoryLock lock(directory);
  claim(directory, study);

  const int jobs = options.jobs > 0 ? options.jobs : cores();
  const bool reference_run = study.reference && study.reference->is_run();
  std::vector<StudyRow> rows;
  std::optional<StudyRow> reference;
  {
    StudyProgress progress(runs.size() + (reference_run ? 1 : 0));
    StudyExecution execution(study, vocabulary, options.program, directory, jobs, cores(), options.trust_geometry,
                             interrupt, progress);
    if (reference_run) {
      const config::PlannedRun run{"reference", study.reference->settings, 0, {}};
      reference = execution.run({run}).front();
      if (reference->succeeded())
        comparison.take_reference(execution.directory_of(run), reference->status == "ruptured");
      else if (!interrupt.requested())
        throw SolverError(fmt::format("the reference {}: {}; its output is in {}", reference->status,
                                      reference->message, (execution.directory_of(run) / "run.log").string()));
    }
    rows = execution.run(runs);
    for (std::size_t r = 0; r < runs.size(); ++r) comparison.compare(execution.directory_of(runs[r]), rows[r]);
  }
  platform::replace_file(directory / "study.csv", study_csv(study, runs, rows));
  const std::vector<fs::path> pictures = drawn(study, runs, rows, directory);
  platform::replace_file(directory / "study.md", study_markdown(study, runs, rows, reference, pictures));
  return result_of(rows, interrupt, directory);
}

}  // namespace creepcontact::study
