#include "axis_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace creepcontact::plot {
namespace {

// Beyond these magnitudes decades and margins are not numbers any more.
constexpr double max_magnitude = 1e250, min_magnitude = 1e-250;
constexpr double rounding = 1e-6;  // of the values: what differs by less is the same on paper

/// Extends the range by the coordinate `pick(x, y)` of all points that are drawn.
template <class Pick>
void extend(Range& range, const Panel& panel, const Axis& x_axis, Pick pick) {
  for (const Series& series : panel.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!is_drawn(series.x[i], series.y[i], x_axis, panel.y)) continue;
      for (const double y : {series.y[i], series.upper.empty() ? series.y[i] : series.upper[i]}) {
        const double value = pick(series.x[i], y);
        range.from = std::min(range.from, value);
        range.to = std::max(range.to, value);
      }
    }
}

Range nothing() {
  return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
}

Range whole_decades(Range range) {
  double low = std::floor(std::log10(range.from) + rounding), high = std::ceil(std::log10(range.to) - rounding);
  if (high <= low) high = low + 1;
  return {std::pow(10, low), std::pow(10, high)};
}

Range with_margin(Range range) {
  const double size = std::max(std::abs(range.from), std::abs(range.to));
  if (range.to - range.from <= rounding * size) {
    const double middle = 0.5 * (range.from + range.to), half = size > 0 ? 0.1 * size : 1;
    return {middle - half, middle + half};
  }
  constexpr double near = 0.4;
  if (range.from > 0 && range.from < near * range.to) range.from = 0;
  if (range.to < 0 && range.to > near * range.from) range.to = 0;
  const double margin = 0.06 * (range.to - range.from);
  return {range.from == 0 ? 0 : range.from - margin, range.to == 0 ? 0 : range.to + margin};
}

}  // namespace

bool is_drawn(double x, double y, const Axis& x_axis, const Axis& y_axis) {
  // A NaN is not at most anything.
  if (!(std::abs(x) <= max_magnitude && std::abs(y) <= max_magnitude)) return false;
  const bool x_fits = !x_axis.logarithmic || x >= min_magnitude || (x == 0 && x_axis.zero_at_left);
  return x_fits && (!y_axis.logarithmic || y >= min_magnitude);
}

Range value_range(const Panel& panel, const Axis& x_axis) {
  Range range = nothing();
  extend(range, panel, x_axis, [](double, double y) { return y; });
  if (range.from > range.to) return panel.y.logarithmic ? Range{0.1, 1} : Range{0, 1};
  return panel.y.logarithmic ? whole_decades(range) : with_margin(range);
}

bool has_zero(const Figure& figure) {
  if (!figure.x.logarithmic || !figure.x.zero_at_left) return false;
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series)
      if (std::ranges::count(series.x, 0.0) > 0) return true;
  return false;
}

Range common_range(const Figure& figure) {
  Axis x = figure.x;
  x.zero_at_left = false;  // the distance of a zero from the other values is chosen here
  Range range = nothing();
  for (const Panel& panel : figure.panels) extend(range, panel, x, [](double value, double) { return value; });
  if (range.from > range.to) return x.logarithmic ? Range{0.1, 1} : Range{0, 1};
  if (!x.logarithmic) return range.from < range.to ? range : Range{range.from - 1, range.to + 1};
  if (range.to < 10 * range.from) {
    constexpr double margin = 1.08;
    const bool few = figure.panels.size() == 1 && range.from < range.to;
    range = few ? Range{range.from / margin, range.to * margin} : whole_decades(range);
  }
  if (has_zero(figure)) {
    const double decades = std::log10(range.to / range.from);
    range.from /= std::pow(10, std::max(0.3, 0.06 * decades));
  }
  return range;
}

}  // namespace creepcontact::plot
