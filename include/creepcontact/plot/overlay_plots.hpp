#pragma once
/// The histories of several runs in common pictures, one per probe.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/plot/curves.hpp"
#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::plot {

/// A run and its name in the legend.
struct LabelledRun {
  std::string label;
  std::filesystem::path directory;
};

/// The last part of each directory's name, or as much of its end as tells them apart.
std::vector<LabelledRun> labelled_by_directory(const std::vector<std::filesystem::path>& directories);

/// The curves of one probe.
struct NamedCurves {
  std::string name;  ///< file name without extension: "history_fit_pressure"
  Curves curves;
};

/// One entry per probe, in the order of options.probes, or of the first run that has it; runs without the probe have no
/// curve. Time is logarithmic if the output times of all runs together span more than three decades.
/// @param labels  one per run @param title  of the pictures, before the name of the probe; may be empty
/// @throws ConfigError if there is no probe at all, or none of a name in options.probes
std::vector<NamedCurves> overlaid(const std::vector<RunTables>& runs, const std::vector<std::string>& labels,
                                  const std::string& title, const PlotOptions& options);

/// Draws `history_<probe>` of these runs into options.directory, which must be given; more than max_series runs are
/// distributed over several pictures (`history_<probe>_2`).
/// @returns the SVG files @throws as overlaid(), read_run_tables() and draw()
std::vector<std::filesystem::path> plot_overlay(const std::vector<LabelledRun>& runs, const std::string& title,
                                                const PlotOptions& options);

}  // namespace creepcontact::plot
