#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "creepcontact/config/study.hpp"

namespace creepcontact::config {
namespace {

/// NaN if the text is none.
double number_or_nan(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> wanted(const Study& study) {
  if (study.plot.over.empty()) return {"time.step", "time.tolerance"};
  std::vector<std::string> keys;
  for (const Reference& key : study.plot.over) keys.push_back(key.name);
  return keys;
}

}  // namespace

const std::vector<std::string>& study_counts() {
  static const std::vector<std::string> names{"steps",        "elastic_solves", "schwarz_iterations",
                                              "wall_seconds", "rejected_steps", "convergence_failures"};
  return names;
}

std::vector<double> numbers(const Axis& axis) {
  std::vector<double> values;
  for (const StudyValue& value : axis.values) values.push_back(number_or_nan(value.label));
  const bool any = std::ranges::any_of(values, [](double value) { return !std::isnan(value); });
  return any ? values : std::vector<double>();
}

bool run_together(const Axis& a, const Axis& b) {
  return a.key.name == b.key.name || (!a.zip.empty() && a.zip == b.zip);
}

std::vector<Product> products(const Study& study) {
  std::vector<Product> all;
  if (!study.axes.empty()) all.push_back({"", {}, study.axes, study.axes.front().location});
  all.insert(all.end(), study.runs.begin(), study.runs.end());
  if (all.empty() && study.random) all.push_back({"", {}, {}, study.random->location});
  return all;
}

std::optional<std::size_t> axis_of_curves(const Study& study, const Product& product) {
  const std::vector<Axis>& axes = product.axes;
  for (const std::string& key : wanted(study))
    for (std::size_t a = 0; a < axes.size(); ++a)
      if (axes[a].key.name == key && !numbers(axes[a]).empty()) return a;
  for (std::size_t a = axes.size(); a-- > 0;)
    if (numbers(axes[a]).size() > 1) return a;
  return std::nullopt;
}

}  // namespace creepcontact::config
