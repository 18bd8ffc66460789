#pragma once
/// What the analysis of a section (Config::analysis) means for the other keys.

#include "creepcontact/config/config.hpp"
#include "diagnostics.hpp"
#include "item.hpp"

namespace creepcontact::config {

/// The axis of axisymmetric models.
inline constexpr std::array<double, 3> y_axis{0, 1, 0};

/// Axes that are not given are y in an axisymmetric model.
void set_section_defaults(const Item& root, Config& config);

/// Keys that have no meaning in this analysis, components out of the plane, and axes other than that of revolution.
void check_sections(const Config& config, const Item& root, Diagnostics& errors);

}  // namespace creepcontact::config
