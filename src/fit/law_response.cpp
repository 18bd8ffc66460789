#include "law_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/material/bar.hpp"

namespace creepcontact::fit {
namespace {

using LawPointer = std::shared_ptr<const material::CreepLaw>;
using Laws = std::span<const LawPointer>;

constexpr double bar_tolerance = 1e-5;
constexpr double beyond_rupture = 20;   // exponent of time
constexpr double rupture_search = 1e8;  // of the measured time
constexpr double rate_search = 1e4;     // of the time to a strain of 0.01
constexpr int rate_points_per_decade = 12;

std::vector<double> times_of(const Test& test) {
  std::vector<double> times;
  for (const Reading& reading : test.readings) times.push_back(reading.time);
  return times;
}

/// The times after rupture, or after the law failed.
void extend(const material::BarHistory& history, const std::vector<double>& times, std::vector<double>& values) {
  const double from = history.rupture.value_or(times.empty() ? 1 : times.back());
  const double last = values.empty() ? history.last.creep_strain : std::max(values.back(), history.last.creep_strain);
  while (values.size() < times.size()) values.push_back(last * std::pow(times[values.size()] / from, beyond_rupture));
}

std::vector<double> creep_strains(Laws laws, const material::BarTest& bar, const std::vector<double>& times) {
  const material::BarHistory history = material::bar_history(laws, bar, times, bar_tolerance);
  std::vector<double> values;
  for (const material::BarState& state : history.states) values.push_back(state.creep_strain);
  if (values.size() < times.size() && !history.rupture) return {};
  extend(history, times, values);
  return values;
}

std::vector<double> rupture_time(Laws laws, const material::BarTest& bar, double measured) {
  const std::array<double, 2> times{1e-6 * measured, rupture_search * measured};
  const material::BarHistory history = material::bar_history(laws, bar, times, bar_tolerance);
  return {history.rupture.value_or(times[1])};
}

double rate_at(Laws laws, const material::BarTest& bar, double time) {
  constexpr double step = 1e-3;
  const std::array<double, 2> times{(1 - step) * time, (1 + step) * time};
  const material::BarHistory history = material::bar_history(laws, bar, times, bar_tolerance);
  if (history.states.size() < 2) return 0;
  return (history.states[1].creep_strain - history.states[0].creep_strain) / (times[1] - times[0]);
}

struct SecondaryRate {
  double rate = 0;
  bool falls_forever = false;
};

/// The rate of a law that has no other: the same at the begin, the middle and the end of the curve; else nothing.
/// It is looked for first, since it costs a tenth of a curve.
std::optional<double> steady_rate(Laws laws, const material::BarTest& bar, double scale) {
  constexpr double same = 1e-7;
  const auto [low, high] = std::minmax(
      {rate_at(laws, bar, scale / rate_search), rate_at(laws, bar, scale), rate_at(laws, bar, scale * rate_search)});
  return low > 0 && high - low <= same * high ? std::optional(low) : std::nullopt;
}

/// The smallest rate of the curve.
SecondaryRate secondary_rate(Laws laws, const material::BarTest& bar, double measured) {
  const double scale = 0.01 / measured;
  if (const auto steady = steady_rate(laws, bar, scale)) return {*steady};
  std::vector<double> times;
  const int n = static_cast<int>(2 * std::log10(rate_search) * rate_points_per_decade);
  for (int i = 0; i <= n; ++i) times.push_back(scale / rate_search * std::pow(rate_search, 2.0 * i / n));
  const material::BarHistory history = material::bar_history(laws, bar, times, bar_tolerance);
  SecondaryRate found;
  double last = 0;
  for (std::size_t i = 1; i < history.states.size(); ++i) {
    last = (history.states[i].creep_strain - history.states[i - 1].creep_strain) / (times[i] - times[i - 1]);
    if (found.rate == 0 || last < found.rate) found.rate = last;
  }
  found.falls_forever = history.states.size() == times.size() && last <= found.rate * (1 + 1e-9) &&
                        history.states[1].creep_strain / times[1] > 2 * last;
  if (found.falls_forever) {  // steady in the end?
    const std::size_t end = times.size() - 1, before = end - rate_points_per_decade;
    const double earlier = (history.states[before].creep_strain - history.states[before - 1].creep_strain) /
                           (times[before] - times[before - 1]);
    found.falls_forever = earlier > 1.02 * last;
  }
  return found;
}

}  // namespace

LawResponse::LawResponse(const TestData& data, std::optional<Function> young_modulus)
    : data_(data), young_modulus_(std::move(young_modulus)), n_readings_(data.n_readings()) {}

std::vector<double> LawResponse::predicted(const LawPointer& law, const Test& test) const {
  const Laws laws(&law, 1);
  material::BarTest bar{.stress = test.stress, .temperature = test.temperature};
  const Reading& first = test.readings.front();
  switch (test.kind) {
    case TestKind::creep:
      return creep_strains(laws, bar, times_of(test));
    case TestKind::rupture:
      return rupture_time(laws, bar, first.value);
    case TestKind::rate: {
      const double rate =
          !std::isnan(first.time) ? rate_at(laws, bar, first.time) : secondary_rate(laws, bar, first.value).rate;
      return rate > 0 ? std::vector{rate} : std::vector<double>();
    }
    case TestKind::relaxation:
      break;
  }
  bar.young_modulus = (*young_modulus_)({.T = test.temperature});
  std::vector<double> values;
  const material::BarHistory history = material::bar_history(laws, bar, times_of(test), bar_tolerance);
  for (const material::BarState& state : history.states) values.push_back(state.stress);
  const double last = std::max(history.last.stress, 1e-6 * test.stress);
  while (history.rupture && values.size() < test.readings.size()) values.push_back(last);
  return values.size() == test.readings.size() ? values : std::vector<double>();
}

std::vector<double> LawResponse::curve(const LawPointer& law, const Test& test,
                                       const std::vector<double>& times) const {
  material::BarTest bar{.stress = test.stress, .temperature = test.temperature};
  const bool relaxes = test.kind == TestKind::relaxation;
  if (relaxes) bar.young_modulus = (*young_modulus_)({.T = test.temperature});
  std::vector<double> values;
  for (const material::BarState& state : material::bar_history(Laws(&law, 1), bar, times).states)
    values.push_back(relaxes ? state.stress : state.creep_strain);
  return values;
}

std::optional<std::vector<double>> LawResponse::residuals(std::span<const LawPointer> laws) const {
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(n_readings_));
  for (const Test& test : data_.tests) {
    const std::vector<double> values = predicted(laws.size() > 1 ? laws[test.batch] : laws.front(), test);
    if (values.size() != test.readings.size()) return std::nullopt;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double residual = std::log((test.readings[i].value + test.floor) / (values[i] + test.floor));
      if (!std::isfinite(residual)) return std::nullopt;
      all.push_back(residual);
    }
  }
  return all;
}

std::string LawResponse::why_impossible(const LawPointer& law) const {
  int without_rupture = 0, without_secondary = 0;
  for (const Test& test : data_.tests) {
    const material::BarTest bar{.stress = test.stress, .temperature = test.temperature};
    const Reading& first = test.readings.front();
    if (test.kind == TestKind::rupture) {
      const std::vector<double> time = rupture_time({&law, 1}, bar, first.value);
      without_rupture += time.empty() || time.front() >= rupture_search * first.value;
    } else if (test.kind == TestKind::rate && std::isnan(first.time)) {
      without_secondary += secondary_rate({&law, 1}, bar, first.value).falls_forever;
    }
  }
  if (without_rupture > 0)
    return fmt::format(
        "the law does not rupture, but the data have {} times to rupture; choose a law with damage "
        "(kachanov_rabotnov), or leave these rows out",
        without_rupture);
  if (without_secondary > 0)
    return fmt::format(
        "the law has no secondary creep: its rate falls for ever, but {} rates have no time; add the time "
        "of each rate in a column 'time', or choose another law",
        without_secondary);
  return "";
}

}  // namespace creepcontact::fit
