#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axis_labels.hpp"
#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::plot {
namespace {

constexpr double lost_beside_others = 50;  // a curve of a fiftieth of the height is flat to the eye

struct Curve {
  QuantityKind kind;
  Series series;
  double size = 0;  // largest magnitude
};

struct Group {
  std::vector<Curve> curves;

  bool takes(const QuantityKind& kind) const {
    const QuantityKind& own = curves.front().kind;
    if (own.dimension != kind.dimension || own.unit != kind.unit) return false;
    return own.dimension != Dimension::none || own.name == kind.name || !own.unit.value_or("").empty();
  }
};

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Curves of one dimension, cut where the magnitudes are too far apart. Those that are zero all the time fit anywhere.
std::vector<Group> by_magnitude(const Group& group) {
  std::vector<Curve> sorted = group.curves;
  std::ranges::stable_sort(sorted, std::ranges::greater(), &Curve::size);
  std::vector<double> tops;
  for (const Curve& curve : sorted)
    if (tops.empty() || (curve.size > 0 && curve.size * lost_beside_others < tops.back())) tops.push_back(curve.size);
  std::vector<Group> groups;
  for (std::size_t g = 0; g < tops.size(); ++g) {
    const double below = g + 1 < tops.size() ? tops[g + 1] : 0;
    Group part;
    for (const Curve& curve : group.curves) {
      const bool is_last = g + 1 == tops.size();
      if (curve.size <= tops[g] && (is_last || curve.size > below)) part.curves.push_back(curve);
    }
    groups.push_back(part);
  }
  return groups;
}

std::string label(const std::vector<Curve>& curves, const std::string& units) {
  std::vector<std::string> names;
  for (const Curve& curve : curves)
    if (std::ranges::count(names, curve.kind.name) == 0) names.push_back(curve.kind.name);
  const std::size_t longest = names.size() == 1 ? 24 : 18;  // of a label next to a panel, with a unit
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  const Dimension dimension = curves.front().kind.dimension;
  const std::string text = all.size() <= longest ? all : name_of(dimension);
  const std::optional<std::string>& unit = curves.front().kind.unit;
  return unit ? with_unit(text, *unit) : labelled(text, dimension, units);
}

}  // namespace

std::vector<Panel> history_panels(const io::CsvTable& history, const io::SummaryHeading& heading) {
  std::vector<Group> groups;
  for (std::size_t c = 1; c < history.names.size(); ++c) {
    const auto known = heading.probes.find(history.names[c]);
    Curve curve{kind_of(known == heading.probes.end() ? io::SummaryProbe{} : known->second, heading.units),
                {history.names[c], history.columns[0], history.columns[c]},
                largest_magnitude(history.columns[c])};
    const auto group = std::ranges::find_if(groups, [&](const Group& g) { return g.takes(curve.kind); });
    if (group == groups.end()) {
      groups.push_back({{curve}});
    } else {
      group->curves.push_back(curve);
    }
  }
  std::vector<Panel> panels;
  for (const Group& dimension : groups)
    for (const Group& group : by_magnitude(dimension)) {
      auto next = group.curves.begin();
      for (std::size_t size : even_parts(group.curves.size(), max_colors)) {
        const std::vector<Curve> curves(next, next + size);
        Panel panel{{label(curves, heading.units)}, {}};
        for (const Curve& curve : curves) panel.series.push_back(curve.series);
        panels.push_back(panel);
        next += static_cast<long>(size);
      }
    }
  return panels;
}

}  // namespace creepcontact::plot
