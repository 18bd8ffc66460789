#pragma once
/// The pictures of a study with random keys.

#include <filesystem>
#include <string>
#include <vector>

#include "result_units.hpp"
#include "scatter.hpp"

namespace creepcontact::study {

/// Draws (.svg, .png, .gp, .dat) per probe `fan_<probe>` (quantiles over time), `histogram_<probe>` (values at the end)
/// and `cloud_<probe>` (values at the end over the key that they depend on most), and `probabilities` (of events, over
/// time). With several combinations of axes the names end with their number, and only the first few are drawn.
/// @param title  of the study
/// @returns the SVG files @throws as plot::draw()
std::vector<std::filesystem::path> plot_scatter(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                                const Scatter& scatter, const ResultUnits& units,
                                                const std::string& title, const std::filesystem::path& directory);

}  // namespace creepcontact::study
