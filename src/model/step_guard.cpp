#include "creepcontact/model/step_guard.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "discontinuities.hpp"

namespace creepcontact::model {
namespace {

constexpr std::size_t n_nodes = 6;    // of the polynomial, of Chebyshev's second kind
constexpr std::size_t n_trials = 13;  // times at which it is compared
constexpr std::size_t places_per_step = 3;
constexpr double deviating = 0.1;          // of the largest deviation
constexpr double least_deviation = 1e-11;  // of the size of a course
constexpr double negligible_size = 1e-3;   // of the largest values: what is smaller is not resolved to its own size
constexpr double resolution = 1e-3;        // of the length found, at ends that are not jumps
constexpr double min_length = 1e-9;        // of the step
constexpr int halvings_of_jump = 6;        // through which a jump stays, and anything continuous shrinks
constexpr double log_from = 1.1;           // ratio of the ends from which on log t is another variable than t
constexpr int samples_of_run = 64;

/// In [0, 1): the fractional part of start + n golden ratios, a sequence of low discrepancy.
double low_discrepancy(double start, std::uint64_t n) {
  const double sum = start + static_cast<double>(n) * (std::numbers::phi - 1);
  return sum - std::floor(sum);
}

/// In [0, 1), unlike for unlike numbers: the finalizer of SplitMix64 (Steele, Lea and Flood 2014).
double scattered(double number) {
  auto bits = std::bit_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31U;
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// A course at one place, from a time on.
class Track {
 public:
  Track(const std::function<double(double)>& course, double from, const StepGuard::Segment& segment, double size)
      : course_(course), from_(from), segment_(segment), least_size_(negligible_size * size) {}

  struct Fit {
    double at = 0, deviation = 0, relative = 0, share = 0;
    bool is_finite = true;
  };

  /// How well a polynomial in t or log t represents the course up to `to`, also at the times at which it has been seen
  /// before.
  Fit fit(double to, double tolerance) {
    const double start = scattered(from_);
    for (std::size_t j = 0; j < n_trials; ++j) {
      const double s = from_ + low_discrepancy(start, j) * (to - from_);
      seen_.emplace_back(s, value(s));
    }
    const Fit in_time = fit_in(
        to, [](double t) { return t; }, [](double t) { return t; });
    if (!in_time.is_finite || in_time.relative <= tolerance || !(from_ > 0) || to < log_from * from_) return in_time;
    const Fit in_log = fit_in(
        to, [](double t) { return std::log(t); }, [](double s) { return std::exp(s); });
    return in_log.relative < in_time.relative ? in_log : in_time;
  }

  double value(double t) const { return course_(std::clamp(t, segment_.begin, segment_.end)); }

 private:
  /// @param map  of the time, monotonic @param inverse  of the map
  template <class Map, class Inverse>
  Fit fit_in(double to, const Map& map, const Inverse& inverse) {
    std::array<double, n_nodes> u{}, v{};
    std::array<std::pair<double, double>, n_nodes> nodes{};
    double size = least_size_;
    const double begin = map(from_), length = map(to) - begin;
    for (std::size_t i = 0; i < n_nodes; ++i) {
      const double share = (1 - std::cos(std::numbers::pi * static_cast<double>(i) / (n_nodes - 1))) / 2;
      u[i] = begin + share * length;
      const double t = i == 0 ? from_ : i + 1 == n_nodes ? to : inverse(u[i]);
      v[i] = value(t);
      if (!std::isfinite(v[i])) return {.is_finite = false};
      size = std::max(size, std::abs(v[i]));
      nodes[i] = {t, v[i]};
    }
    Fit worst{.at = to};
    for (const auto& [t, found] : seen_) {
      if (t > to) continue;
      if (!std::isfinite(found)) return {.is_finite = false};
      size = std::max(size, std::abs(found));
      if (const double deviation = std::abs(found - interpolated(u, v, map(t))); deviation > worst.deviation)
        worst = {.at = t, .deviation = deviation};
    }
    worst.relative = size > 0 ? worst.deviation / size : 0;
    std::size_t n = 0, n_deviating = 0;
    for (const auto& [t, found] : seen_) {
      if (t > to) continue;
      ++n;
      if (std::abs(found - interpolated(u, v, map(t))) > deviating * worst.deviation) ++n_deviating;
    }
    seen_.insert(seen_.end(), nodes.begin(), nodes.end());
    worst.share = n > 0 ? static_cast<double>(n_deviating) / static_cast<double>(n) : 0;
    return worst;
  }

  /// Barycentric interpolation (Berrut and Trefethen 2004).
  static double interpolated(const std::array<double, n_nodes>& t, const std::array<double, n_nodes>& v, double s) {
    double above = 0, below = 0;
    for (std::size_t i = 0; i < n_nodes; ++i) {
      if (s == t[i]) return v[i];
      const bool is_end = i == 0 || i + 1 == n_nodes;
      const double weight = (i % 2 == 0 ? 1.0 : -1.0) * (is_end ? 0.5 : 1.0) / (s - t[i]);
      above += weight * v[i];
      below += weight;
    }
    return above / below;
  }

  const std::function<double(double)>& course_;
  double from_;
  StepGuard::Segment segment_;
  double least_size_;
  std::vector<std::pair<double, double>> seen_;  // times and values
};

}  // namespace

StepGuard::StepGuard(std::vector<CoursesInTime> courses, double end, double tolerance)
    : courses_(std::move(courses)), tolerance_(std::max(tolerance, least_deviation)) {
  for (const CoursesInTime& course : courses_) {
    double size = 0;
    for (int i = 0; i < samples_of_run; ++i) {
      const auto& at_place = course.at_places[static_cast<std::size_t>(i) * course.at_places.size() / samples_of_run];
      const double value = at_place(end * low_discrepancy(0.5, static_cast<std::uint64_t>(i)));
      if (std::isfinite(value)) size = std::max(size, std::abs(value));
    }
    sizes_.push_back(size);
  }
}

std::optional<StepGuard::Finding> StepGuard::examine(std::size_t index, double from, double to,
                                                     const Segment& segment) const {
  const CoursesInTime& course = courses_[index];
  std::optional<Finding> first;
  const std::size_t n_places = std::min(places_per_step, course.at_places.size());
  const double start = scattered(-from);
  for (std::size_t k = 0; k < n_places; ++k) {
    const auto place =
        n_places == course.at_places.size()
            ? k
            : static_cast<std::size_t>(low_discrepancy(start, k) * static_cast<double>(course.at_places.size()));
    Track track(course.at_places[place], from, segment, sizes_[index]);
    double bad = first ? first->time : to, good = from;
    const auto found = track.fit(bad, tolerance_);
    if (!found.is_finite || found.relative <= tolerance_) continue;
    Finding finding{.course = index,
                    .at = found.at,
                    .deviation = found.deviation,
                    .relative = found.relative,
                    .share = found.share};
    const auto halve = [&] {
      const double middle = good + 0.5 * (bad - good);
      if (!(good < middle && middle < bad)) return false;
      const auto fit = track.fit(middle, tolerance_);
      (fit.is_finite && fit.relative <= tolerance_ ? good : bad) = middle;
      return true;
    };
    const double length = to - from;
    while (bad - good > resolution * (good - from) && bad - good > min_length * length && halve()) {
    }
    // A jump stays as large however close one looks.
    const auto change = [&] { return std::abs(track.value(bad) - track.value(good)); };
    const double before = change();
    for (int i = 0; i < halvings_of_jump && halve(); ++i) {
    }
    finding.is_jump = before > 0 && change() > 0.5 * before;
    while (finding.is_jump && halve()) {
    }
    // Between two neighbouring times a continuous function, however steep, hardly changes.
    constexpr double of_deviation = 1e-2;
    finding.is_jump = finding.is_jump && change() > of_deviation * found.deviation;
    if (finding.is_jump && bad >= to) continue;  // at the end of the step, where it is seen
    finding.time = finding.is_jump ? rounder(good, bad) : std::max(good, from + min_length * length);
    if (finding.is_jump && !(finding.time > from)) finding.time = bad;
    if (!first || finding.time < first->time) first = finding;
  }
  return first;
}

}  // namespace creepcontact::model
