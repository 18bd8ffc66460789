#include "repetition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace creepcontact::model {
namespace {

constexpr double same = 1e-7, similar = 1e-4;  // of the largest value
constexpr double most_phases = 2000;
constexpr std::int64_t most_different = 64;
constexpr double different_share = 0.05;
constexpr double rounding = 1e-9;  // of a cycle

/// @param allowed  difference
bool is_same(double a, double b, double allowed) {
  return std::abs(a - b) <= allowed || (!std::isfinite(a) && !std::isfinite(b));
}

double largest_value(const Course& course, double from, double period) {
  constexpr int phases = 61;
  double largest = 0;
  for (int i = 0; i < phases; ++i)
    if (const double v = course(from + period * (i + 0.37) / phases); std::isfinite(v))
      largest = std::max(largest, std::abs(v));
  return largest;
}

struct Event {
  double time;
  bool is_jump;
};

std::vector<Event> events(const Course& course, Interval over, int samples) {
  const Discontinuities found = find_discontinuities(course, over, samples);
  std::vector<Event> all;
  for (const double t : found.jumps) all.push_back({t, true});
  for (const double t : found.kinks) all.push_back({t, false});
  std::ranges::sort(all, {}, &Event::time);
  return all;
}

/// @param over  where to compare: longer than the period
bool has_period(const Course& course, double period, Interval over) {
  constexpr int samples = 499;
  const double allowed = similar * largest_value(course, over.low, over.high - over.low);
  for (int i = 0; i < samples; ++i) {
    const double t = over.low + (over.high - period - over.low) * (i + 0.37) / samples;
    if (!is_same(course(t), course(t + period), allowed)) return false;
  }
  return true;
}

}  // namespace

std::optional<Repetition> Repetition::find(const Course& course, double end, double period, double comparisons,
                                           int fewest_phases) {
  Repetition result;
  result.period_ = period;
  result.count_ = static_cast<std::int64_t>(std::floor(end / period * (1 + rounding * period / end)));
  const std::int64_t n = result.count_;
  const double per_cycle =
      std::clamp(comparisons / static_cast<double>(n), static_cast<double>(fewest_phases), most_phases);
  const auto phases = static_cast<std::int64_t>(per_cycle);
  const auto allowed = std::max(most_different, static_cast<std::int64_t>(different_share * static_cast<double>(n)));
  const std::array<std::int64_t, 3> patterns{1, n / 3, n / 2};
  for (std::size_t trial = 0; trial < patterns.size(); ++trial) {
    const std::int64_t pattern = patterns[trial];
    if (pattern < 1 || (trial > 0 && pattern <= patterns[trial - 1])) continue;
    result.pattern_ = pattern;
    result.different_.clear();
    const double allowed_change = same * largest_value(course, static_cast<double>(pattern) * period, period);
    for (std::int64_t k = 1; k <= n && std::ssize(result.different_) <= allowed; ++k) {
      if (k == pattern) continue;
      const double shift = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
      for (std::int64_t i = 0; i < phases; ++i) {
        const double phase = (static_cast<double>(i) + shift) / static_cast<double>(phases);
        const double t = (static_cast<double>(k) + phase) * period;
        if (t > end) break;
        const double expected = course((static_cast<double>(pattern) + phase) * period);
        if (is_same(course(t), expected, allowed_change)) continue;
        result.different_.insert(k);
        break;
      }
    }
    // Most cycles must be like the pattern, or nothing is won.
    if (std::ssize(result.different_) <= std::min(allowed, n / 2)) return result;
  }
  return std::nullopt;
}

std::vector<Interval> Repetition::different(double end) const {
  std::vector<Interval> result;
  std::int64_t last = -2;
  for (const std::int64_t k : different_) {
    const double begin = static_cast<double>(k) * period_;
    const double until = std::min(end, static_cast<double>(k + 1) * period_);
    if (!(until > begin * (1 + rounding))) continue;
    if (k == last + 1)
      result.back().high = until;
    else
      result.push_back({begin, until});
    last = k;
  }
  return result;
}

std::optional<double> find_period(const Course& course, double end) {
  constexpr double begin = 0.37;  // of the run
  constexpr std::size_t fewest_events = 12;
  constexpr int window_samples = 4093, near_samples = 256;
  for (double width = end / 64; width > 1e-9 * end; width /= 4) {
    const double from = begin * end;
    const std::vector<Event> found = events(course, {from, from + width}, window_samples);
    if (found.size() < fewest_events) continue;
    for (std::size_t lag = 1; lag < found.size() / 2; ++lag) {
      if (found[lag].is_jump != found[0].is_jump) continue;
      double period = found[lag].time - found[0].time;
      if (!has_period(course, period, {found[0].time, found.back().time})) continue;
      // The same event many periods later tells the period more exactly.
      for (double n = 2; found[0].time + (n + 1) * period < end; n *= 2) {
        const double expected = found[0].time + n * period, reach = 0.02 * period;
        const std::vector<Event> later = events(course, {expected - reach, expected + reach}, near_samples);
        if (later.empty()) break;
        const auto nearest =
            std::ranges::min_element(later, {}, [&](const Event& event) { return std::abs(event.time - expected); });
        period = (nearest->time - found[0].time) / n;
      }
      return rounded(period, 1e-11 * period, 9);
    }
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace creepcontact::model
