#pragma once
/// Figures of a finished or failed run, from the tables in its output directory.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_table.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/plot/figure.hpp"

namespace creepcontact::plot {

/// Options of plot_run().
struct PlotOptions {
  std::optional<bool> log_time = {};     ///< logarithmic time axis; default: see spans_decades()
  std::vector<std::string> probes = {};  ///< names of probes; empty: all
  std::filesystem::path directory = {};  ///< of the figures; empty: `plots` in the directory of the run
};

/// Draws history.{svg,png} (also history_2 and so on if one figure cannot hold all panels), if the run has steps
/// steps.{svg,png}, and if it has cycles cycles.{svg,png} (also cycles_2 and so on). Units are those of summary.json,
/// if it exists.
/// @returns the SVG files
/// @throws ConfigError if the directory or its history.csv does not exist, if there are fewer than two rows or a probe
/// is unknown; and as draw()
std::vector<std::filesystem::path> plot_run(const std::filesystem::path& run, const PlotOptions& options);

/// The data of a run that its figures are drawn from.
struct RunTables {
  std::filesystem::path directory;  ///< of the run; names it in messages, and in figures if it has no title
  io::CsvTable history, steps;      ///< `steps` has no rows if nothing creeps
  io::SummaryHeading heading;
  io::CsvTable cycles = {};  ///< without rows if the run has no cycles
};

/// Reads the tables in the output directory of a run; without summary.json there are a warning, no title and no units.
/// @throws ConfigError if the directory or its history.csv does not exist or cannot be read
RunTables read_run_tables(const std::filesystem::path& run);
/// Reads the tables with a heading that the caller has.
RunTables read_run_tables(const std::filesystem::path& run, io::SummaryHeading heading);

/// A figure and the name of its files.
struct NamedFigure {
  std::string name;  ///< without extension
  Figure figure;
};

/// The figures drawn by plot_run().
/// @throws ConfigError if there are fewer than two rows, or a probe is unknown
std::vector<NamedFigure> run_figures(RunTables run, const PlotOptions& options);

/// One panel per physical dimension, in the order of the probes. Probes whose values are so small that they would
/// coincide with the axis (a fiftieth of the others), and those beyond the capacity of a panel, get additional panels.
/// Probes of unknown quantities are grouped by magnitude only.
std::vector<Panel> history_panels(const io::CsvTable& history, const io::SummaryHeading& heading);
/// Step length, order, and, if there is contact, iterations of the contact solver and active contacts.
Figure steps_figure(const io::CsvTable& steps, const io::SummaryHeading& heading, bool log_time);

/// Over the number of the cycle: smallest and largest values of the probes, strain ranges, fractions of life.
/// @param cycles  cycles.csv, with its column `cycle` @param probes  names; empty: all
std::vector<Panel> cycle_panels(const io::CsvTable& cycles, const io::SummaryHeading& heading,
                                const std::vector<std::string>& probes);

/// True if the positive times span more than three decades.
bool spans_decades(const std::vector<double>& times);

}  // namespace creepcontact::plot
