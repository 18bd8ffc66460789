#pragma once
/// Ends of the axes of a figure.

#include <vector>

#include "creepcontact/plot/figure.hpp"

namespace creepcontact::plot {

struct Range {
  double from = 0, to = 1;
};

/// A point that can be drawn: of at most 1e250, and on logarithmic axes of at least 1e-250 (but for zero_at_left).
bool is_drawn(double x, double y, const Axis& x_axis, const Axis& y_axis);

/// Vertical. Linear: a little beyond the values; values that are the same but for rounding lie in the middle of a range
/// that does not magnify the rounding; zero is shown where it is near. Logarithmic: whole decades.
Range value_range(const Panel& panel, const Axis& x_axis);

/// Horizontal, common to all panels; logarithmic with at least a decade above each other. With a point at x = 0 that
/// zero_at_left shows, `from` is its position.
Range common_range(const Figure& figure);
bool has_zero(const Figure& figure);

}  // namespace creepcontact::plot
