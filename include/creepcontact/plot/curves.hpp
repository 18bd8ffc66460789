#pragma once
/// Pictures of curves, of as many as there are: what an accuracy costs, method by method.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/plot/figure.hpp"

namespace creepcontact::plot {

struct Curves {
  std::string title;
  Axis x, y;
  std::vector<Series> series;  ///< points in any order
};

/// One picture `<stem>`; more curves than it takes are spread evenly over several (`<stem>_2`). Points that an axis
/// cannot show (a logarithmic one nothing that is zero, negative or no number) are left out, and so are curves without
/// points.
/// @returns the SVG files; none without points
/// @throws as draw()
std::vector<std::filesystem::path> draw_curves(const Curves& curves, const std::filesystem::path& directory,
                                               const std::string& stem);

}  // namespace creepcontact::plot
