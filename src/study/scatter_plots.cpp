#include "scatter_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/plot/figure.hpp"
#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::study {
namespace {

constexpr std::size_t most_groups_drawn = 6, most_points = 3000;
constexpr double far_apart = 10;  // ratio of values from which on an axis is logarithmic

using Style = plot::Series::Style;

/// The largest over the smallest value; 0: not all are positive.
double ratio_of(const std::vector<double>& values) {
  const auto [least, largest] = std::ranges::minmax(values);
  return least > 0 ? largest / least : 0;
}

plot::Axis time_axis(const std::vector<double>& times, const std::string& unit) {
  return {.label = unit.empty() ? "time" : fmt::format("time ({})", unit),
          .logarithmic = plot::spans_decades(times),
          .zero_at_left = true};
}

plot::Series series_of(const std::string& name, Style style, int look = 0) {
  plot::Series series;
  series.name = name;
  series.style = style;
  series.look = look;
  return series;
}

class ScatterPictures {
 public:
  ScatterPictures(const Scatter& scatter, const ResultUnits& units, const std::string& title,
                  const std::filesystem::path& directory)
      : scatter_(scatter), units_(units), title_(title), directory_(directory) {}

  /// @param suffix  of the names of files
  void draw_fan(const ScatterGroup& group, std::size_t probe, const std::string& suffix) {
    const QuantileCourse& course = group.probes[probe];
    plot::Series outer = series_of("5 % to 95 %", Style::band), inner = series_of("25 % to 75 %", Style::dark_band),
                 median = series_of("median", Style::bare_line);
    for (std::size_t t = 0; t < group.times.size(); ++t) {
      const Fan& fan = course.fan[t];
      if (std::isnan(fan[0])) continue;
      for (plot::Series* one : {&outer, &inner, &median}) one->x.push_back(group.times[t]);
      outer.y.push_back(fan[0]);
      outer.upper.push_back(fan[4]);
      inner.y.push_back(fan[1]);
      inner.upper.push_back(fan[3]);
      median.y.push_back(fan[2]);
    }
    draw(group, time_axis(group.times, units_.time),
         {{.label = units_.labelled(scatter_.probes[probe])}, {outer, inner, median}},
         "fan_" + scatter_.probes[probe] + suffix);
  }

  void draw_histogram(const ScatterGroup& group, std::size_t probe, const std::string& suffix) {
    const std::vector<double> sorted = sorted_known(group.results[end_of_probe(probe)].values);
    if (sorted.size() < 2 || !(sorted.front() < sorted.back())) return;
    const bool is_logarithmic = ratio_of(sorted) > far_apart;
    const auto scaled = [&](double value) { return is_logarithmic ? std::log(value) : value; };
    const double low = scaled(sorted.front()), high = scaled(sorted.back());
    const auto n = std::clamp<std::size_t>(static_cast<std::size_t>(2 * std::cbrt(sorted.size())), 5, 50);
    std::vector<double> shares(n, 0.0);
    for (const double value : sorted) {
      const double position = (scaled(value) - low) / (high - low) * static_cast<double>(n);
      shares[std::min(n - 1, static_cast<std::size_t>(position))] += 100.0 / static_cast<double>(sorted.size());
    }
    plot::Series bins = series_of(fmt::format("{} runs", sorted.size()), Style::dark_band);
    for (std::size_t i = 0; i < n; ++i)
      for (const std::size_t edge : {i, i + 1}) {
        const double x = low + (high - low) * static_cast<double>(edge) / static_cast<double>(n);
        bins.x.push_back(is_logarithmic ? std::exp(x) : x);
        bins.y.push_back(0);
        bins.upper.push_back(shares[i]);
      }
    draw(group, {.label = units_.labelled(scatter_.probes[probe], " at the end"), .logarithmic = is_logarithmic},
         {{.label = "share of the runs (%)"}, {bins}}, "histogram_" + scatter_.probes[probe] + suffix);
  }

  void draw_cloud(const ScatterGroup& group, const std::vector<config::PlannedRun>& runs, std::size_t probe,
                  const std::string& suffix) {
    const std::size_t result = end_of_probe(probe), key = leading_key(group, result);
    if (key == scatter_.keys.size()) return;
    plot::Series points =
        series_of(fmt::format("rank correlation {:+.2f}", group.rank_correlations[result][key]), Style::points);
    const std::vector<double>& values = group.results[result].values;
    for (std::size_t s = 0; s < values.size() && points.x.size() < most_points; ++s) {
      if (!std::isfinite(values[s])) continue;
      points.x.push_back(runs[group.runs[s]].sampled[key]);
      points.y.push_back(values[s]);
    }
    draw(group, {.label = scatter_.keys[key], .logarithmic = ratio_of(points.x) > far_apart},
         {{.label = units_.labelled(scatter_.probes[probe], " at the end"),
           .logarithmic = ratio_of(points.y) > far_apart},
          {points}},
         "cloud_" + scatter_.probes[probe] + suffix);
  }

  void draw_probabilities(const ScatterGroup& group, const std::string& suffix) {
    plot::Panel panel{{.label = "probability (%)"}, {}};
    int look = 0;
    for (const Happening& one : group.happenings) {
      if (one.is_at_end || panel.series.size() + 2 > plot::max_series) continue;
      plot::Series bounds = series_of(one.name + ", 95 % bounds", Style::band, look);
      plot::Series share = series_of(one.name, Style::bare_line, look++);
      for (const double time : group.times) {
        const statistics::Proportion p = probability_at(one, time);
        bounds.x.push_back(time);
        bounds.y.push_back(100 * p.low);
        bounds.upper.push_back(100 * p.high);
        share.x.push_back(time);
        share.y.push_back(100 * p.value);
      }
      panel.series.insert(panel.series.end(), {bounds, share});
    }
    if (!panel.series.empty()) draw(group, time_axis(group.times, units_.time), panel, "probabilities" + suffix);
  }

  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  void draw(const ScatterGroup& group, const plot::Axis& x, const plot::Panel& panel, const std::string& name) {
    const std::string stem = plot::file_stem(name);
    plot::draw({group.label.empty() ? title_ : title_ + ": " + group.label, x, {panel}}, directory_, stem);
    files_.push_back(directory_ / (stem + ".svg"));
  }

  const Scatter& scatter_;
  const ResultUnits& units_;
  std::string title_;
  std::filesystem::path directory_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace

std::vector<std::filesystem::path> plot_scatter(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                                const Scatter& scatter, const ResultUnits& units,
                                                const std::string& title, const std::filesystem::path& directory) {
  ScatterPictures pictures(scatter, units, title, directory);
  if (!study.plot.histories) return {};
  for (std::size_t g = 0; g < std::min(most_groups_drawn, scatter.groups.size()); ++g) {
    const ScatterGroup& group = scatter.groups[g];
    const std::string suffix = scatter.groups.size() > 1 ? fmt::format("_{}", g + 1) : "";
    if (group.times.size() > 1) pictures.draw_probabilities(group, suffix);
    for (std::size_t p = 0; p < scatter.probes.size(); ++p) {
      if (group.times.size() > 1) pictures.draw_fan(group, p, suffix);
      pictures.draw_histogram(group, p, suffix);
      pictures.draw_cloud(group, runs, p, suffix);
    }
  }
  return pictures.files();
}

}  // namespace creepcontact::study
