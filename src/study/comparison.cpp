#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace creepcontact::study {
namespace {

/// Includes the extremes between output times.
void widen(ProbeCourse& course, const ProbeCourse& extremes) {
  if (std::isnan(course.min)) return;
  course.min = std::min(course.min, extremes.min);
  course.max = std::max(course.max, extremes.max);
}

}  // namespace

Comparison::Comparison(const config::Study& study) : study_(study) {
  if (!study.reference || study.reference->is_run()) return;
  if (study.reference->expressions.empty())
    reference_.emplace(io::read_csv_table(study.reference->csv), study.reference->csv.string(),
                       study.compare.quantities);
  else
    reference_.emplace(study.reference->expressions);
}

void Comparison::take_reference(const RunOutcome& outcome, const std::string& name) {
  io::CsvTable history = outcome.history;
  if (outcome.row.status == "ruptured")  // its last row is of the time of rupture, at which no other run has an output
    for (std::vector<double>& column : history.columns) column.pop_back();
  reference_.emplace(std::move(history), name, study_.compare.quantities);
}

void Comparison::compare(const RunOutcome& outcome, StudyRow& row) const {
  const std::size_t n = study_.compare.quantities.size();
  row.courses.assign(n, {});
  if (study_.reference) row.errors.assign(n, std::numeric_limits<double>::quiet_NaN());
  if (!row.succeeded() || n == 0) return;
  for (std::size_t q = 0; q < n; ++q) {
    const std::string& name = study_.compare.quantities[q].name;
    const std::vector<double>* const column = outcome.history.column(name);
    if (column == nullptr || column->empty()) continue;
    row.courses[q] = course_of(*column);
    if (outcome.extremes.contains(name)) widen(row.courses[q], outcome.extremes.at(name));
    if (!reference_) continue;
    const auto [value, message] =
        reference_->error(outcome.history, name, study_.compare.norm, row.status == "completed");
    row.errors[q] = value;
    if (!message.empty()) row.message = message + (row.message.empty() ? "" : "; ") + row.message;
  }
}

}  // namespace creepcontact::study
