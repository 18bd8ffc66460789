#include "creepcontact/plot/overlay_plots.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "axis_labels.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"

namespace creepcontact::plot {
namespace {

/// The probes of all runs, in the order in which they first appear.
std::vector<std::string> probes_of(const std::vector<RunTables>& runs) {
  std::vector<std::string> names;
  for (const RunTables& run : runs)
    for (std::size_t c = 1; c < run.history.names.size(); ++c)
      if (std::ranges::count(names, run.history.names[c]) == 0) names.push_back(run.history.names[c]);
  return names;
}

/// The end of a path: so many of its parts.
std::string end_of(const std::filesystem::path& path, std::size_t parts) {
  std::filesystem::path whole = path.lexically_normal(), end;
  if (!whole.has_filename()) whole = whole.parent_path();  // "results/a/"
  for (std::size_t i = 0; i < parts && !whole.empty() && whole != whole.parent_path(); ++i) {
    end = end.empty() ? whole.filename() : whole.filename() / end;
    whole = whole.parent_path();
  }
  return end.empty() ? path.string() : end.string();
}

std::size_t n_parts(const std::filesystem::path& path) {
  return static_cast<std::size_t>(std::distance(path.begin(), path.end()));
}

}  // namespace

std::vector<LabelledRun> labelled_by_directory(const std::vector<std::filesystem::path>& directories) {
  std::size_t longest = 1;
  for (const std::filesystem::path& directory : directories) longest = std::max(longest, n_parts(directory));
  std::vector<LabelledRun> runs;
  for (std::size_t parts = 1; parts <= longest; ++parts) {
    runs.clear();
    std::set<std::string> seen;
    for (const std::filesystem::path& directory : directories) {
      runs.push_back({end_of(directory, parts), directory});
      seen.insert(runs.back().label);
    }
    if (seen.size() == runs.size()) break;
  }
  return runs;
}

std::vector<NamedCurves> overlaid(const std::vector<RunTables>& runs, const std::vector<std::string>& labels,
                                  const std::string& title, const PlotOptions& options) {
  const std::vector<std::string> known = probes_of(runs);
  if (known.empty()) throw ConfigError("the runs have no probes; add some in [[probes]] of the configuration");
  for (const std::string& name : options.probes)
    if (std::ranges::count(known, name) == 0)
      throw ConfigError(fmt::format("--probes: no run has a probe '{}'{} (there are: {})", name,
                                    did_you_mean(name, known), fmt::join(known, ", ")));
  std::vector<double> times;
  for (const RunTables& run : runs)
    times.insert(times.end(), run.history.columns[0].begin(), run.history.columns[0].end());
  const bool log_time = options.log_time.value_or(spans_decades(times));

  std::vector<NamedCurves> all;
  std::set<std::string> names;  // those that differ in other characters alone are not one file
  for (const std::string& probe : options.probes.empty() ? known : options.probes) {
    const io::SummaryHeading* heading = nullptr;  // of the first run that has the probe
    NamedCurves one;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::vector<double>* values = runs[r].history.column(probe);
      if (values == nullptr) continue;
      if (heading == nullptr) heading = &runs[r].heading;
      one.curves.series.push_back({labels[r], runs[r].history.columns[0], *values});
    }
    const auto kept = heading->probes.find(probe);
    const QuantityKind kind =
        kind_of(kept == heading->probes.end() ? io::SummaryProbe{} : kept->second, heading->units);
    one.curves.title = title.empty() ? probe : fmt::format("{}: {}", title, probe);
    one.curves.x = {labelled("time", Dimension::time, heading->units), log_time, true};
    one.curves.y = {kind.unit ? with_unit(kind.name, *kind.unit) : labelled(kind.name, kind.dimension, heading->units)};
    one.name = "history_" + file_stem(probe);
    for (int n = 2; !names.insert(one.name).second; ++n) one.name = fmt::format("history_{}__{}", file_stem(probe), n);
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<std::filesystem::path> plot_overlay(const std::vector<LabelledRun>& runs, const std::string& title,
                                                const PlotOptions& options) {
  std::vector<RunTables> tables;
  std::vector<std::string> labels;
  for (const LabelledRun& run : runs) {
    tables.push_back(read_run_tables(run.directory));
    labels.push_back(run.label);
  }
  std::vector<std::filesystem::path> pictures;
  for (const NamedCurves& one : overlaid(tables, labels, title, options)) {
    const auto drawn = draw_curves(one.curves, options.directory, one.name);
    pictures.insert(pictures.end(), drawn.begin(), drawn.end());
  }
  return pictures;
}

}  // namespace creepcontact::plot
