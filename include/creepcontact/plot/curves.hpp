#pragma once
/// Figures of any number of curves, such as cost against accuracy, one curve per method.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/plot/figure.hpp"

namespace creepcontact::plot {

/// A set of curves with common axes.
struct Curves {
  std::string title;
  Axis x, y;
  std::vector<Series> series;  ///< points in any order
};

/// Draws one figure `<stem>`; if there are too many curves for one, they are distributed evenly over several
/// (`<stem>_2`). Points that an axis cannot show (on a logarithmic axis: zero, negative or NaN) and curves without
/// points are left out.
/// @returns the SVG files; empty if there are no points
/// @throws as draw()
std::vector<std::filesystem::path> draw_curves(const Curves& curves, const std::filesystem::path& directory,
                                               const std::string& stem);

}  // namespace creepcontact::plot
