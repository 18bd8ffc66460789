#include "creepcontact/plot/run_plots.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "axis_labels.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/suggestion.hpp"

namespace creepcontact::plot {
namespace {

constexpr std::size_t max_panels = 5;  // of a picture: what a screen shows

std::string title(const RunTables& run) {
  const io::SummaryHeading& heading = run.heading;
  const std::string name = heading.title.empty() ? run.directory.lexically_normal().string() : heading.title;
  const bool whole = heading.status.empty() || heading.status == "completed";
  return whole ? name : fmt::format("{} ({})", name, heading.status);
}

Axis time_axis(const io::SummaryHeading& heading, bool logarithmic) {
  return {labelled("time", Dimension::time, heading.units), logarithmic, true};
}

/// Why there is no picture of the probes; empty if there is one.
std::string why_no_curves(const RunTables& run) {
  const std::string path = (run.directory / "history.csv").string();
  const io::CsvTable& history = run.history;
  if (history.names.size() < 2)
    return fmt::format("'{}' has no probes; add some in [[probes]] of the configuration", path);
  if (history.rows() < 2)
    return fmt::format("'{}' has {} row{}; a curve needs at least two output times", path, history.rows(),
                       history.rows() == 1 ? "" : "s");
  return "";
}

/// The time and these columns, in the order asked for.
io::CsvTable chosen(const io::CsvTable& history, const std::vector<std::string>& probes, const std::string& path) {
  const std::vector<std::string> known(history.names.begin() + 1, history.names.end());
  io::CsvTable result{{history.names[0]}, {history.columns[0]}};
  for (const std::string& name : probes) {
    if (std::ranges::count(known, name) == 0)
      throw ConfigError(fmt::format("--probes: no probe '{}' in '{}'{} (there are: {})", name, path,
                                    did_you_mean(name, known), fmt::join(known, ", ")));
    if (std::ranges::count(result.names, name) > 0) continue;
    result.names.push_back(name);
    result.columns.push_back(*history.column(name));
  }
  return result;
}

}  // namespace

bool spans_decades(const std::vector<double>& times) {
  double first = INFINITY, last = 0;
  for (double time : times) {
    if (time > 0) first = std::min(first, time);
    last = std::max(last, time);
  }
  return last > 1e3 * first;
}

Figure steps_figure(const io::CsvTable& steps, const io::SummaryHeading& heading, bool log_time) {
  const auto curve = [&](const char* column, const char* name, Series::Style style) {
    const std::vector<double>* values = steps.column(column);
    if (values == nullptr) throw ConfigError(fmt::format("steps.csv has no column '{}'", column));
    return Series{name, steps.columns[0], *values, style};
  };
  const auto whole = [](const char* label) { return Axis{.label = label, .whole_numbers = true}; };
  const auto any = [](const Series& series) {
    return std::ranges::any_of(series.y, [](double value) { return value != 0; });
  };
  using Style = Series::Style;
  const Series solves = curve("elastic_solves", "elastic solves", Style::points);
  const Series iterations = curve("schwarz_iterations", "Schwarz iterations", Style::points);
  const Series contacts = curve("active_contacts", "active contacts", Style::steps);

  const Axis length{labelled("step length", Dimension::time, heading.units), true};
  Figure figure{heading.title, time_axis(heading, log_time), {}};
  figure.panels.push_back({length, {curve("step", "step length", Style::steps)}});
  figure.panels.push_back({whole("order"), {curve("order", "order", Style::steps)}});
  figure.panels.push_back({whole("per step"), {solves}});
  if (any(iterations)) figure.panels.back().series.push_back(iterations);
  if (any(contacts)) figure.panels.push_back({whole("multipliers"), {contacts}});
  return figure;
}

std::vector<NamedFigure> run_figures(RunTables run, const PlotOptions& options) {
  const std::string missing = why_no_curves(run);
  if (!missing.empty()) {
    if (run.steps.rows() < 2 || !options.probes.empty()) throw ConfigError(missing);
    log::warning("{}; only the time steps are plotted", missing);
    run.history = run.steps;  // for its times
  }
  if (!options.probes.empty())
    run.history = chosen(run.history, options.probes, (run.directory / "history.csv").string());
  const bool log_time = options.log_time.value_or(spans_decades(run.history.columns[0]));

  std::vector<NamedFigure> figures;
  const std::vector<Panel> panels = missing.empty() ? history_panels(run.history, run.heading) : std::vector<Panel>();
  auto next = panels.begin();
  for (std::size_t size : even_parts(panels.size(), max_panels)) {
    const std::string name = figures.empty() ? "history" : fmt::format("history_{}", figures.size() + 1);
    figures.push_back({name, {title(run), time_axis(run.heading, log_time), {next, next + size}}});
    next += static_cast<long>(size);
  }
  if (run.steps.rows() > 0) {
    Figure figure = steps_figure(run.steps, run.heading, log_time);
    figure.title = title(run) + ": time steps";
    figures.push_back({"steps", std::move(figure)});
  }
  std::vector<NamedFigure> of_cycles;
  if (run.cycles.rows() > 1) {
    if (run.cycles.column("cycle") == nullptr) throw ConfigError("cycles.csv has no column 'cycle'");
    const std::vector<double>& numbers = *run.cycles.column("cycle");
    const std::vector<Panel> all = cycle_panels(run.cycles, run.heading, options.probes);
    auto first = all.begin();
    for (std::size_t size : even_parts(all.size(), max_panels)) {
      const std::string name = of_cycles.empty() ? "cycles" : fmt::format("cycles_{}", of_cycles.size() + 1);
      const Axis x{.label = "cycle", .logarithmic = spans_decades(numbers)};
      of_cycles.push_back({name, {title(run) + ": cycles", x, {first, first + size}}});
      first += static_cast<long>(size);
    }
  }
  for (NamedFigure& one : figures)
    for (const auto& [event, time] : run.heading.events) one.figure.marks.push_back({time, event});
  std::ranges::move(of_cycles, std::back_inserter(figures));
  return figures;
}

}  // namespace creepcontact::plot
