#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "creepcontact/simulation/study_results.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<double> numbers(const config::Axis& axis) {
  std::vector<double> values;
  for (const config::StudyValue& value : axis.values) {
    const auto found = number(value.label);
    if (!found) return {};
    values.push_back(*found);
  }
  return values;
}

bool run_together(const config::Axis& a, const config::Axis& b) {
  return a.key.name == b.key.name || (!a.zip.empty() && a.zip == b.zip);
}

}  // namespace

std::vector<StudySeries> series(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                const std::vector<StudyRow>& rows) {
  std::vector<StudySeries> all;
  for (const config::Axis& axis : study.axes) {
    const std::vector<double> values = numbers(axis);
    if (values.size() < 2) continue;
    std::map<std::string, std::size_t> found;  // index in `all` by label
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (runs[r].point.empty()) continue;
      std::string label;
      double x = 0;
      for (std::size_t a = 0; a < study.axes.size(); ++a) {
        const auto index = static_cast<std::size_t>(runs[r].point[a]);
        if (&study.axes[a] == &axis) x = values[index];
        if (run_together(study.axes[a], axis)) continue;
        label += fmt::format("{}{} = {}", label.empty() ? "" : ", ", study.axes[a].key.name,
                             study.axes[a].values[index].label);
      }
      const auto [place, is_new] = found.try_emplace(label, all.size());
      if (is_new) all.push_back({axis.key.name, label, {}, {}, {}, {}});
      StudySeries& one = all[place->second];
      const StudyRow& row = rows[r];
      one.x.push_back(x);
      one.elastic_solves.push_back(row.succeeded() ? static_cast<double>(row.elastic_solves) : unknown);
      one.wall_seconds.push_back(row.succeeded() ? row.wall_seconds : unknown);
      one.errors.resize(study.compare.quantities.size());
      for (std::size_t q = 0; q < one.errors.size(); ++q) one.errors[q].push_back(row.errors[q]);
    }
  }
  return all;
}

std::vector<double> observed_orders(const std::vector<double>& x, const std::vector<double>& errors) {
  std::vector<double> orders;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
    const bool known = errors[i] > 0 && errors[i + 1] > 0 && x[i] > 0 && x[i + 1] > 0 && x[i] != x[i + 1];
    orders.push_back(known ? std::log(errors[i] / errors[i + 1]) / std::log(x[i] / x[i + 1]) : unknown);
  }
  return orders;
}

}  // namespace creepcontact::simulation
