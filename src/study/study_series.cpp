#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "study_results.hpp"

namespace creepcontact::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::string last_part(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

/// Words speak for themselves, numbers need the last part of their key, or all of it where others end so or where
/// it says nothing: "beta_euler", "beta = 0.5", "materials.steel.n = 5", "temperature.value = 500".
std::string short_text(const config::Product& product, const std::string& key, const config::StudyValue& value) {
  const bool is_word = value.label != value.toml;
  if (is_word) return value.label;
  const std::string last = last_part(key);
  const auto ends_so = [&](const std::string& other) { return last_part(other) == last; };
  const auto others = std::ranges::count_if(product.settings, ends_so, &config::Setting::key) +
                      std::ranges::count_if(product.axes, ends_so, [](const config::Axis& a) { return a.key.name; });
  return fmt::format("{} = {}", others > 1 || last == "value" ? key : last, value.label);
}

void append(std::string& label, const std::string& part) {
  label += (label.empty() ? "" : ", ") + part;
}

std::string label_of(const config::Product& product, const config::PlannedRun& run, const config::Axis* along) {
  std::string label = product.label;
  if (label.empty())
    for (const config::Setting& setting : product.settings)
      append(label, short_text(product, setting.key, setting.value));
  for (std::size_t a = 0; a < product.axes.size(); ++a) {
    const config::Axis& axis = product.axes[a];
    if (!along || !config::run_together(axis, *along))
      append(label, short_text(product, axis.key.name, axis.values[run.point[a]]));
  }
  return label;
}

/// The entries of a legend: all are different, and if there are several, each has a name.
class Legend {
 public:
  explicit Legend(std::size_t entries) : entries_(entries) {}
  std::string entry(const std::string& label) {
    const std::string text = label.empty() && entries_ > 1 ? "as the base" : label;
    const int before = seen_[text]++;
    return before > 0 ? fmt::format("{} ({})", text, before + 1) : text;
  }

 private:
  std::size_t entries_;
  std::map<std::string, int> seen_;
};

}  // namespace

double StudyRow::count(const std::string& column) const {
  if (!counted) return unknown;
  for (const Field& field : fields)
    if (field.name == column) return static_cast<double>(this->*field.value);
  return wall_seconds;
}

std::vector<double> StudySeries::errors(const std::vector<StudyRow>& rows, std::size_t quantity) const {
  std::vector<double> all;
  for (const std::size_t run : runs) all.push_back(rows[run].errors[quantity]);
  return all;
}

std::vector<double> StudySeries::counts(const std::vector<StudyRow>& rows, const std::string& column) const {
  std::vector<double> all;
  for (const std::size_t run : runs) all.push_back(rows[run].succeeded() ? rows[run].count(column) : unknown);
  return all;
}

std::vector<double> StudySeries::ends(const std::vector<StudyRow>& rows, std::size_t quantity) const {
  std::vector<double> all;
  for (const std::size_t run : runs)
    all.push_back(quantity < rows[run].courses.size() ? rows[run].courses[quantity].end : unknown);
  return all;
}

std::vector<StudySeries> series(const config::Study& study, const std::vector<config::PlannedRun>& runs) {
  std::vector<StudySeries> all;
  const std::vector<config::Product> products = config::products(study);
  std::map<std::pair<std::size_t, std::string>, std::size_t> found;  // index in `all`
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const config::Product& product = products[runs[r].product];
    const auto along = config::axis_of_curves(study, product);
    const config::Axis* axis = along ? &product.axes[*along] : nullptr;
    const std::string label = label_of(product, runs[r], axis);
    const auto [position, is_new] = found.try_emplace({runs[r].product, label}, all.size());
    if (is_new) all.push_back({axis ? axis->key.name : "", label, {}, {}});
    StudySeries& one = all[position->second];
    one.x.push_back(axis ? config::numbers(*axis)[runs[r].point[*along]] : unknown);
    one.runs.push_back(r);
  }
  Legend legend(all.size());
  for (StudySeries& one : all) one.label = legend.entry(one.label);
  return all;
}

std::vector<std::string> run_labels(const config::Study& study, const std::vector<config::PlannedRun>& runs) {
  const std::vector<config::Product> all = config::products(study);
  Legend legend(runs.size());
  std::vector<std::string> labels;
  labels.reserve(runs.size());
  for (const config::PlannedRun& run : runs) labels.push_back(legend.entry(label_of(all[run.product], run, nullptr)));
  return labels;
}

ProbeCourse course_of(const std::vector<double>& values) {
  ProbeCourse course{.start = values.front(), .end = values.back()};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    course.min = std::isnan(course.min) ? value : std::min(course.min, value);
    course.max = std::isnan(course.max) ? value : std::max(course.max, value);
  }
  return course;
}

std::vector<double> observed_orders(const std::vector<double>& x, const std::vector<double>& errors) {
  std::vector<double> orders;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
    const bool known = errors[i] > 0 && errors[i + 1] > 0 && x[i] > 0 && x[i + 1] > 0 && x[i] != x[i + 1];
    orders.push_back(known ? std::log(errors[i] / errors[i + 1]) / std::log(x[i] / x[i + 1]) : unknown);
  }
  return orders;
}

}  // namespace creepcontact::study
