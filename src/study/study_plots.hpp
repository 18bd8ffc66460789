#pragma once
/// The pictures of a study: its errors and counts over what was varied, its errors over what they cost.

#include <filesystem>
#include <vector>

#include "study_results.hpp"

namespace creepcontact::study {

/// The title, or the name of the file.
std::string title_of(const config::Study& study);

/// If the study compares probes: `history_<probe>`, the histories of all runs; without a reference also
/// `<probe>_end_over_<key>`. Files `<column>_over_<column>` (.svg, .png, .gp, .dat) by the columns of study.csv, one
/// for each key that curves run along. A curve has the same colour and marker in all of them, if there are no more
/// curves than a picture takes.
/// @returns the SVG files
/// @throws ConfigError or Error as plot::draw()
std::vector<std::filesystem::path> plot_study(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                              const std::vector<StudyRow>& rows,
                                              const std::filesystem::path& directory);

}  // namespace creepcontact::study
