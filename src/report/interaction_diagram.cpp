#include "interaction_diagram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

namespace creepcontact::report {
namespace {

using Points = std::vector<std::array<double, 2>>;  // creep life used, fatigue life used

/// The diagrams of the materials with fatigue data: each from (0, 1) through the points of the configuration to (1, 0).
std::map<std::string, Points> interaction_diagrams(const std::vector<io::RecordedInput>& inputs) {
  constexpr std::string_view before = "materials.", after = ".fatigue.";
  std::map<std::string, Points> all;
  for (const io::RecordedInput& input : inputs) {
    const std::size_t end = input.key.rfind(after);
    if (!input.key.starts_with(before) || end == std::string::npos || end < before.size()) continue;
    Points& points = all[input.key.substr(before.size(), end - before.size())];
    if (!input.key.ends_with(".interaction")) continue;
    const nlohmann::json given = nlohmann::json::parse(input.value, nullptr, false);
    if (!given.is_array()) continue;
    for (const nlohmann::json& point : given)
      if (point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number())
        points.push_back({point[0].get<double>(), point[1].get<double>()});
  }
  for (auto& [material, points] : all) {
    points.insert(points.begin(), {0, 1});
    points.push_back({1, 0});
  }
  return all;
}

/// The part of a line within 0 to `limits`.
plot::Series clipped(const std::string& name, const Points& line, const std::array<double, 2>& limits) {
  plot::Series part{name, {}, {}, plot::Series::Style::bare_line};
  for (std::size_t i = 1; i < line.size(); ++i) {
    double from = 0, to = 1;  // along the piece
    for (std::size_t k = 0; k < 2; ++k) {
      const double a = line[i - 1][k], change = line[i][k] - a;
      if (change == 0 && a > limits[k]) to = -1;
      if (change > 0) to = std::min(to, (limits[k] - a) / change);
      if (change < 0) from = std::max(from, (limits[k] - a) / change);
    }
    if (from >= to) continue;
    for (const double s : {from, to}) {
      part.x.push_back(line[i - 1][1] + s * (line[i][1] - line[i - 1][1]));
      part.y.push_back(line[i - 1][0] + s * (line[i][0] - line[i - 1][0]));
    }
  }
  return part;
}

}  // namespace

std::optional<plot::Figure> interaction_figure(const std::vector<std::string>& bodies, const io::CsvTable& cycles,
                                               const std::vector<io::RecordedInput>& inputs) {
  constexpr double margin = 1.5;
  plot::Figure figure;
  figure.x.label = "fatigue life used";
  figure.panels.push_back({{"creep life used"}, {}});
  std::vector<plot::Series>& series = figure.panels[0].series;
  std::array<double, 2> shown{0, 0};
  const auto show = [&](const std::vector<double>& values, std::size_t k) {
    for (const double value : values)
      if (std::isfinite(value)) shown[k] = std::max(shown[k], margin * value);
  };
  for (const std::string& body : bodies) {
    const std::vector<double>*fatigue = cycles.column(body + ".fatigue_fraction"),
          *creep = cycles.column(body + ".life_fraction");
    if (fatigue == nullptr || creep == nullptr || series.size() + 1 >= plot::max_series) continue;
    plot::Series& one = series.emplace_back(plot::Series{body, {0}, {0}});
    one.x.insert(one.x.end(), fatigue->begin(), fatigue->end());
    one.y.insert(one.y.end(), creep->begin(), creep->end());
    show(*creep, 0);
    show(*fatigue, 1);
  }
  if (series.empty()) return std::nullopt;
  const std::map<std::string, Points> diagrams = interaction_diagrams(inputs);
  for (const auto& [material, points] : diagrams) {
    // A straight line is shown whole, others around their inner points.
    const std::size_t ends = points.size() == 2 ? 0 : 1;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = ends; i + ends < points.size(); ++i) show({points[i][k]}, k);
  }
  for (double& limit : shown) limit = std::min(limit, 1.0);
  for (const auto& [material, points] : diagrams)
    if (plot::Series line = clipped("limit of " + material, points, shown);
        !line.x.empty() && series.size() < plot::max_series)
      series.push_back(std::move(line));
  return figure;
}

}  // namespace creepcontact::report
