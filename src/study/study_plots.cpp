#include "study_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/plot/overlay_plots.hpp"
#include "creepcontact/study/study.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

std::string described(const std::string& column) {
  if (column == "wall_seconds") return "wall-clock time (s)";
  if (column == "schwarz_iterations") return "Schwarz iterations";
  if (column == "elastic_solves") return "elastic solves";
  return column;
}

constexpr std::size_t max_overlaid = 4 * plot::max_series;  // runs: beyond, nobody reads the legends

/// The histories of the runs that have one.
std::vector<fs::path> overlay(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                              const fs::path& directory, const std::string& title, const plot::PlotOptions& options) {
  const std::vector<std::string> labels = run_labels(study, runs);
  std::vector<plot::LabelledRun> found;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (const fs::path run = directory / "runs" / runs[r].name; path_exists(run / "history.csv"))
      found.push_back({labels[r], run});
  if (found.size() <= max_overlaid)
    return found.empty() ? std::vector<fs::path>{} : plot_overlay(found, title, options);
  log::warning(
      "{} runs are too many for pictures of their histories (at most {}); creepcontact plot draws a few of them",
      found.size(), max_overlaid);
  return {};
}

enum class Zero { is_linear, is_left_out };

/// Whether the largest value is at least so many times the least, so that the axis is to be logarithmic.
bool spans(double ratio, Zero zero, const std::vector<plot::Series>& all, std::vector<double> plot::Series::*list) {
  double least = INFINITY, largest = 0;
  for (const plot::Series& one : all)
    for (const double value : one.*list) {
      if (value < 0 || (value == 0 && zero == Zero::is_linear)) return false;
      if (value == 0 || !std::isfinite(value)) continue;
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  return largest >= ratio * least;
}

class Pictures {
 public:
  Pictures(const config::Study& study, std::vector<StudySeries> curves, const std::vector<StudyRow>& rows,
           const std::filesystem::path& directory)
      : title_(title_of(study)), curves_(std::move(curves)), rows_(rows), directory_(directory) {
    for (const StudySeries& curve : curves_)
      if (!curve.axis.empty() && std::ranges::count(axes_, curve.axis) == 0) axes_.push_back(curve.axis);
  }

  using Values = std::function<std::vector<double>(const StudySeries&)>;
  /// Draws a column over what varies along the curves: one picture per key.
  void over_settings(const std::string& column, const std::string& label, const Values& values, bool is_error) {
    const double far_apart = is_error ? 1 : 10;  // errors have orders, seen in a log-log plot alone
    for (const std::string& axis : axes_) {
      plot::Curves picture{title_, {.label = axis}, {.label = label}, series(axis, values)};
      picture.x.logarithmic = spans(far_apart, Zero::is_linear, picture.series, &plot::Series::x);
      picture.y.logarithmic = is_error || spans(far_apart, Zero::is_left_out, picture.series, &plot::Series::y);
      draw(picture, column, axis);
    }
  }
  void over_count(const std::string& column, const std::string& label, const Values& values, const std::string& count) {
    plot::Curves picture{title_,
                         {.label = described(count), .logarithmic = true},
                         {.label = label, .logarithmic = true},
                         series({}, values)};
    for (std::size_t c = 0; c < picture.series.size(); ++c) picture.series[c].x = curves_[c].counts(rows_, count);
    draw(picture, column, count);
  }
  std::vector<std::filesystem::path> files() const { return files_; }

 private:
  /// @param axis  of the curves; empty: all of them
  std::vector<plot::Series> series(const std::string& axis, const Values& values) const {
    std::vector<plot::Series> all;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const StudySeries& curve = curves_[c];
      if (!axis.empty() && curve.axis != axis) continue;
      plot::Series& one = all.emplace_back();
      one.name = curve.label;
      one.x = curve.x;
      one.y = values(curve);
      if (curves_.size() <= plot::max_series) one.look = static_cast<int>(c);
    }
    return all;
  }
  void draw(const plot::Curves& picture, const std::string& column, const std::string& over) {
    const std::string name = fmt::format("{}_over_{}", plot::file_stem(column), plot::file_stem(over));
    std::string stem = name;
    for (int n = 2; !stems_.insert(stem).second; ++n) stem = fmt::format("{}__{}", name, n);
    const auto drawn = plot::draw_curves(picture, directory_, stem);
    files_.insert(files_.end(), drawn.begin(), drawn.end());
  }

  std::string title_;
  std::vector<StudySeries> curves_;
  const std::vector<StudyRow>& rows_;
  std::filesystem::path directory_;
  std::vector<std::string> axes_;
  std::vector<std::filesystem::path> files_;
  std::set<std::string> stems_;  // names that differ in other letters alone are not one file
};

}  // namespace

std::string title_of(const config::Study& study) {
  return study.title.empty() ? study.file.stem().string() : study.title;
}

std::vector<std::filesystem::path> plot_study(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                              const std::vector<StudyRow>& rows,
                                              const std::filesystem::path& directory) {
  Pictures pictures(study, series(study, runs), rows, directory);
  for (std::size_t q = 0; q < study.compare.quantities.size(); ++q) {
    const std::string& quantity = study.compare.quantities[q].name;
    if (!study.reference) {
      pictures.over_settings(
          quantity + "_end", quantity + " at the end", [&](const StudySeries& curve) { return curve.ends(rows, q); },
          false);
      continue;
    }
    const std::string column = "error_" + quantity, label = fmt::format("relative error of {}", quantity);
    const auto errors = [&](const StudySeries& curve) { return curve.errors(rows, q); };
    pictures.over_settings(column, label, errors, true);
    for (const char* count : {"elastic_solves", "wall_seconds"}) pictures.over_count(column, label, errors, count);
  }
  for (const std::string& column : study.plot.show)
    pictures.over_settings(
        column, described(column), [&](const StudySeries& curve) { return curve.counts(rows, column); }, false);
  std::vector<fs::path> files;
  if (study.plot.histories && !study.compare.quantities.empty()) {
    plot::PlotOptions options{.directory = directory};
    for (const config::Reference& quantity : study.compare.quantities) options.probes.push_back(quantity.name);
    files = overlay(study, runs, directory, title_of(study), options);
  }
  const std::vector<fs::path> others = pictures.files();
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

bool is_study_directory(const fs::path& directory) {
  return path_exists(directory / stored_study);
}

std::vector<fs::path> plot_study_histories(const fs::path& directory, plot::PlotOptions options) {
  const config::Study study = config::read_study(directory / stored_study);
  if (options.directory.empty()) options.directory = directory / "plots";
  std::vector<fs::path> pictures = overlay(study, config::plan(study), directory, "", options);
  if (pictures.empty())
    throw ConfigError(fmt::format("'{}': no run of this study has a history yet", directory.string()));
  return pictures;
}

}  // namespace creepcontact::study
