#pragma once
/// Reports: one HTML file with what a run was given and what came out, which opens without a network.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::report {

struct ReportOptions {
  std::filesystem::path output;  ///< empty: report.html in the directory of the run; with several, in the working one
  bool pdf = false;              ///< a PDF file instead of a page: report.pdf
  double limit_mb = 20;          ///< of the fields of all runs together; they are thinned to keep it
};

struct WrittenReport {
  std::filesystem::path file;
  double megabytes = 0;
  std::vector<std::string> notes = {};  ///< what is missing or was left out, a sentence each
};

/// One run, or several, compared. The directory of a study is replaced by those of its runs. A run that was interrupted
/// or has failed is reported as far as it came.
/// @param runs  output directories, at least one.
/// @throws ConfigError if one of them is not an output directory (saying what to name instead) or the file cannot be
/// written; ModelError if field files are damaged; SolverError as ChildProcess.
/// Cost: reading the field files; processes of gnuplot and Python, some seconds.
WrittenReport write_report(const std::vector<std::filesystem::path>& runs, const ReportOptions& options);

}  // namespace creepcontact::report
