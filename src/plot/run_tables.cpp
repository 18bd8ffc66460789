/// Reads and writes the files of a run's pictures.

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::plot {
namespace {

io::CsvTable read_history(const std::filesystem::path& run) {
  if (!path_is_directory(run))
    throw ConfigError(fmt::format("no directory '{}'; plot needs the output directory of a run", run.string()));
  const std::filesystem::path path = run / "history.csv";
  if (!path_exists(path))
    throw ConfigError(fmt::format("no history.csv in '{}'; plot needs the output directory of a run", run.string()));
  return io::read_csv_table(path, io::UnendedRow::is_left_out);
}

/// Without rows if there is no such file.
io::CsvTable read_if_any(const std::filesystem::path& path) {
  if (!path_exists(path)) return {};
  return io::read_csv_table(path, io::UnendedRow::is_left_out);
}

io::SummaryHeading heading_of(const std::filesystem::path& run) {
  try {
    return io::read_summary_heading(run / "summary.json");
  } catch (const ConfigError& error) {
    log::warning("{}: the pictures have no title and no units", error.what());
    return {};
  }
}

}  // namespace

RunTables read_run_tables(const std::filesystem::path& run) {
  io::CsvTable history = read_history(run), steps = read_if_any(run / "steps.csv");
  return {run, std::move(history), std::move(steps), heading_of(run), read_if_any(run / "cycles.csv")};
}

RunTables read_run_tables(const std::filesystem::path& run, io::SummaryHeading heading) {
  return {run, read_history(run), read_if_any(run / "steps.csv"), std::move(heading), read_if_any(run / "cycles.csv")};
}

std::vector<std::filesystem::path> plot_run(const std::filesystem::path& run, const PlotOptions& options) {
  const std::vector<NamedFigure> figures = run_figures(read_run_tables(run), options);
  const std::filesystem::path directory = options.directory.empty() ? run / "plots" : options.directory;
  if (options.directory.empty()) platform::make_inner_directory(directory);
  std::vector<std::filesystem::path> pictures;
  for (const NamedFigure& one : figures) {
    draw(one.figure, directory, one.name);
    pictures.push_back(directory / (one.name + ".svg"));
  }
  return pictures;
}

}  // namespace creepcontact::plot
