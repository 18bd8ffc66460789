#pragma once
/// Pictures of a finished (or failed) run, from the tables in its output directory.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/io/csv_table.hpp"
#include "creepcontact/io/summary.hpp"
#include "creepcontact/plot/figure.hpp"

namespace creepcontact::plot {

struct PlotOptions {
  std::optional<bool> log_time = {};     ///< not given: if the output times span more than three decades
  std::vector<std::string> probes = {};  ///< names; empty: all
  std::filesystem::path directory = {};  ///< of the pictures; empty: plots in the run's directory
};

/// Draws history.{svg,png} (and history_2 and so on if one picture does not hold all panels) and steps.{svg,png}, the
/// latter if the run has steps. Units are those of summary.json, if there is one.
/// @returns the SVG files
/// @throws ConfigError if there is no such directory, no history.csv in it, fewer than two rows, or no such probe; as
/// draw()
std::vector<std::filesystem::path> plot_run(const std::filesystem::path& run, const PlotOptions& options);

/// What the pictures of a run are drawn from.
struct RunTables {
  std::filesystem::path directory;  ///< of the run: its title in the pictures if it has none, and its name in messages
  io::CsvTable history, steps;      ///< the latter without rows if nothing creeps
  io::SummaryHeading heading;
};

struct NamedFigure {
  std::string name;  ///< of the picture's files, without their endings
  Figure figure;
};

/// The figures that plot_run() draws.
/// @throws ConfigError if there are fewer than two rows, or no such probe
std::vector<NamedFigure> run_figures(RunTables run, const PlotOptions& options);

/// A panel for each physical dimension, in the order of the probes; probes that would lie on the axis beside others (a
/// fiftieth of them) and more than a panel takes go into panels of their own. Probes of a quantity that is not known
/// are grouped by magnitude alone.
std::vector<Panel> history_panels(const io::CsvTable& history, const io::SummaryHeading& heading);
/// Step length, order, iterations of the contact solver, and active contacts (the last two if there is contact).
Figure steps_figure(const io::CsvTable& steps, const io::SummaryHeading& heading, bool log_time);

bool spans_decades(const std::vector<double>& times);

}  // namespace creepcontact::plot
