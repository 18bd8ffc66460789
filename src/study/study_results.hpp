#pragma once
/// What the runs of a study came to, as tables and as curves.

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/config/study.hpp"

namespace creepcontact::study {

/// The study as it was read, in its output directory.
inline constexpr const char* stored_study = "study_input.toml";

/// A probe over a run: at its first and last output time, and its extremes. NaN: not known.
struct ProbeCourse {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double start = unknown, end = unknown, min = unknown, max = unknown;
};
/// Values that are not finite do not count as least or largest. @param values  at the output times, at least one
ProbeCourse course_of(const std::vector<double>& values);

/// Numbers that are not known are NaN.
struct StudyRow : RunCounters {
  std::string status;                           ///< "completed", "ruptured", "failed", "interrupted", "not started"
  std::string message;                          ///< why it failed or has no error; the warnings of a run that succeeded
  std::vector<double> errors;                   ///< relative, one per quantity; empty without reference
  std::vector<ProbeCourse> courses = {};        ///< one per quantity
  std::map<std::string, double> criteria = {};  ///< utilisation by name; NaN: not judged
  std::map<std::string, double> events = {};    ///< time by name; NaN: did not happen
  double wall_seconds = 0;
  double end_time = ProbeCourse::unknown;  ///< that the run reached
  bool counted = false;                    ///< whether the run left a summary, and so the numbers above
  bool succeeded() const { return status == "completed" || status == "ruptured"; }
  /// @param column  of config::study_counts(). @returns NaN if the run left no summary
  double count(const std::string& column) const;
};

/// Runs that differ in the value of one axis (and of those zipped with it) alone.
struct StudySeries {
  std::string axis;               ///< key; empty: a product without an axis of numbers, each of whose runs is a series
  std::string label;              ///< of the product and values of its other axes: "beta_euler, beta = 0.5"
  std::vector<double> x;          ///< values of the axis, in the order of the study; NaN without axis
  std::vector<std::size_t> runs;  ///< indices of the rows

  std::vector<double> errors(const std::vector<StudyRow>& rows, std::size_t quantity) const;
  std::vector<double> counts(const std::vector<StudyRow>& rows, const std::string& column) const;
  /// Values of a quantity at the end.
  std::vector<double> ends(const std::vector<StudyRow>& rows, std::size_t quantity) const;
};

/// The curves of a study, along config::axis_of_curves(), in its order.
std::vector<StudySeries> series(const config::Study& study, const std::vector<config::PlannedRun>& runs);

/// One name per run, of its label and the values of all its axes, no two alike: "beta_euler, step = 0.1".
std::vector<std::string> run_labels(const config::Study& study, const std::vector<config::PlannedRun>& runs);

/// log(e_i/e_(i+1))/log(x_i/x_(i+1)), one less than there are errors; NaN where one is 0 or not known.
std::vector<double> observed_orders(const std::vector<double>& x, const std::vector<double>& errors);

}  // namespace creepcontact::study
