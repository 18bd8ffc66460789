#pragma once
/// What the runs of a study came to, as tables and as series for plots.

#include <cstdint>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"

namespace creepcontact::simulation {

/// Numbers that are not known are NaN.
struct StudyRow {
  std::string status;  ///< "completed", "ruptured", "failed", "interrupted", "not started"
  std::string message;
  std::vector<double> errors;  ///< relative, one a quantity
  std::int64_t steps = 0, elastic_solves = 0, schwarz_iterations = 0;
  double wall_seconds = 0;
  bool counted = false;  ///< whether the run left a summary, and so the numbers above
  bool succeeded() const { return status == "completed" || status == "ruptured"; }
};

/// Runs that differ in the value of one axis (and of those zipped with it) alone.
struct StudySeries {
  std::string axis;       ///< key
  std::string label;      ///< values of the other axes: "time.integrator = beta_euler"; empty without others
  std::vector<double> x;  ///< values of the axis, in the order of the study
  std::vector<double> elastic_solves, wall_seconds;
  std::vector<std::vector<double>> errors;  ///< [quantity][i]
};

/// One for every axis whose values are all numbers, at least two, and every combination of the others.
/// @param rows  one a run
std::vector<StudySeries> series(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                const std::vector<StudyRow>& rows);

/// log(e_i/e_(i+1))/log(x_i/x_(i+1)), one less than there are errors; NaN where one is 0 or not known.
std::vector<double> observed_orders(const std::vector<double>& x, const std::vector<double>& errors);

}  // namespace creepcontact::simulation
