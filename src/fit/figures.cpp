/// Pictures of a fit: curves and residuals.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/fit/report.hpp"
#include "creepcontact/plot/figure.hpp"
#include "law_response.hpp"

namespace creepcontact::fit {
namespace {

constexpr int points_of_curve = 120;

std::string in_unit(const std::string& what, const std::string& unit) {
  return unit.empty() ? what : fmt::format("{} [{}]", what, unit);
}

std::string legend(const TestData& data, const Test& test) {
  return test.is_named ? fmt::format("{}, {}", test.name, data.load(test.stress, test.temperature)) : test.name;
}

std::string short_name(const TestData& data) {
  return std::filesystem::path(data.file).filename().string();
}

plot::Figure figure_of(std::string title, plot::Axis x, plot::Panel panel) {
  plot::Figure figure{.title = std::move(title), .x = std::move(x), .panels = {}};
  figure.panels.push_back(std::move(panel));
  return figure;
}

/// Measured points and the fitted line of some curves.
plot::Figure curves_figure(const TestData& data, const LawResponse& response, const FitResult& result, TestKind kind,
                           std::size_t first, std::size_t n) {
  plot::Panel panel{{kind == TestKind::creep ? "creep strain" : in_unit("stress", data.units.stress), true}, {}};
  int look = 0;
  std::size_t number = 0;
  for (const Test& test : data.tests) {
    if (test.kind != kind || number++ < first || number > first + n) continue;
    plot::Series measured{legend(data, test), {}, {}, plot::Series::Style::points, look};
    for (const Reading& reading : test.readings) {
      measured.x.push_back(reading.time);
      measured.y.push_back(reading.value);
    }
    std::vector<double> times;
    times.reserve(points_of_curve);
    const double from = measured.x.front(), to = measured.x.back();
    for (int i = 0; i < points_of_curve; ++i)
      times.push_back(from * std::pow(to / from, static_cast<double>(i) / (points_of_curve - 1)));
    plot::Series line{"", times, response.curve(result.law, test, times), plot::Series::Style::bare_line, look};
    line.x.resize(line.y.size());
    panel.series.push_back(std::move(measured));
    panel.series.push_back(std::move(line));
    ++look;
  }
  return figure_of(fmt::format("{}: measured (points), {} (lines)", short_name(data), result.law->name()),
                   {in_unit("time", data.units.time), true}, std::move(panel));
}

plot::Figure residuals_figure(const TestData& data, const FitResult& result) {
  plot::Panel over_time{{"residual in %"}, {}};
  std::array<plot::Series, n_test_kinds> kinds;
  for (int k = 0; k < n_test_kinds; ++k) {
    kinds[static_cast<std::size_t>(k)].name = name_of(static_cast<TestKind>(k));
    kinds[static_cast<std::size_t>(k)].style = plot::Series::Style::points;
  }
  for (std::size_t t = 0; t < data.tests.size(); ++t) {
    const Test& test = data.tests[t];
    plot::Series& series = kinds[static_cast<std::size_t>(test.kind)];
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
      const double time = test.kind == TestKind::rupture ? test.readings[i].value : test.readings[i].time;
      series.x.push_back(std::isnan(time) ? test.stress : time);
      series.y.push_back(100 * std::expm1(result.residuals[t][i]));
    }
  }
  for (plot::Series& series : kinds)
    if (!series.x.empty()) over_time.series.push_back(std::move(series));
  const bool times = result.range.time.high > 0;
  return figure_of(fmt::format("{}: measured against fitted values", short_name(data)),
                   {times ? in_unit("time", data.units.time) : in_unit("stress", data.units.stress), true},
                   std::move(over_time));
}

/// Times to rupture and secondary rates over the stress.
plot::Figure stress_figure(const TestData& data, const LawResponse& response, const FitResult& result, TestKind kind) {
  plot::Series measured{"measured", {}, {}, plot::Series::Style::points, 0};
  plot::Series fitted{"fitted", {}, {}, plot::Series::Style::points, 1};
  for (const Test& test : data.tests) {
    if (test.kind != kind) continue;
    measured.x.push_back(test.stress);
    measured.y.push_back(test.readings.front().value);
    const std::vector<double> value = response.predicted(result.law, test);
    fitted.x.push_back(test.stress);
    fitted.y.push_back(value.empty() ? std::nan("") : value.front());
  }
  plot::Panel panel{{value_of(kind), true}, {}};
  panel.series.push_back(std::move(measured));
  panel.series.push_back(std::move(fitted));
  return figure_of(short_name(data), {in_unit("stress", data.units.stress), true}, std::move(panel));
}

}  // namespace

std::vector<std::filesystem::path> draw_fit(const TestData& data, const FitResult& result,
                                            const std::optional<Function>& young_modulus,
                                            const std::filesystem::path& directory) {
  const LawResponse response(data, young_modulus);
  std::vector<std::filesystem::path> pictures;
  const auto add = [&](const plot::Figure& figure, const std::string& stem) {
    plot::draw(figure, directory, stem);
    pictures.push_back(directory / (stem + ".svg"));
  };
  for (const TestKind kind : {TestKind::creep, TestKind::relaxation}) {
    const auto n = static_cast<std::size_t>(std::ranges::count(data.tests, kind, &Test::kind));
    std::size_t first = 0;
    int number = 1;
    for (const std::size_t part : plot::even_parts(n, plot::max_series / 2)) {
      add(curves_figure(data, response, result, kind, first, part),
          number == 1 ? name_of(kind) : fmt::format("{}_{}", name_of(kind), number));
      first += part;
      ++number;
    }
  }
  for (const TestKind kind : {TestKind::rupture, TestKind::rate})
    if (std::ranges::count(data.tests, kind, &Test::kind) > 0)
      add(stress_figure(data, response, result, kind), name_of(kind));
  add(residuals_figure(data, result), "residuals");
  return pictures;
}

}  // namespace creepcontact::fit
