#include "discontinuities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace creepcontact::model {
namespace {

constexpr int fewest_samples = 64;
constexpr double first_sample = 1e-10, log_ratio = 1.024;  // over the end; between samples near 0
constexpr double standing_out = 0.02;  // deviation of a slope change from its neighbours, over these: not smooth
constexpr double negligible = 1e-7;    // over the range of the values
constexpr double persistent = 0.3;     // of a slope change through three refinements, of a kink's
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr std::size_t finer = 8;  // refinement of a level
constexpr std::size_t margin = 6, stencil = 3;
constexpr std::size_t longest_cluster = 8, max_kinks = 4000, trials = 24;
constexpr double at_border = 1e-11;  // relative: a kink at the begin of the interval belongs to it
constexpr int max_evaluations = 500000, deepest = 40;

/// Adjacent nodes with conspicuous slope changes: one or several kinks.
struct Cluster {
  std::size_t first, last;
};

struct Grid {
  std::vector<double> t, v;
  double slope(std::size_t j) const { return (v[j + 1] - v[j]) / (t[j + 1] - t[j]); }  // behind node j
  double change(std::size_t j) const { return slope(j) - slope(j - 1); }
  double strength(std::size_t j) const { return std::abs(change(j)) + std::abs(change(j + 1)); }
};

/// A smooth function, seen closely enough, has slope changes that vary smoothly from sample to sample; a kink has one
/// that deviates from its neighbours at any resolution. Suspicious samples are refined until rounding dominates.
class Search {
 public:
  Search(const Course& course, Interval over, int samples)
      : course_(course), begin_(over.low), end_(over.high), n_samples_(std::max(samples, fewest_samples)) {}

  Discontinuities run() {
    const Grid grid = samples();
    const auto [least, largest] = std::minmax_element(grid.v.begin(), grid.v.end());
    const std::vector<Cluster> found = clusters(grid, negligible * (*largest - *least));
    std::size_t n_nodes = 0;
    for (const Cluster& cluster : found) n_nodes += cluster.last - cluster.first + 1;
    const bool crowded = n_nodes > grid.t.size() / 2;
    if (crowded && !is_smooth_closer(grid, found)) too_many_ = true;
    if (!crowded)
      for (const Cluster& cluster : found) examine(grid, cluster, {}, 0);
    if (too_many_ || kinks_.size() + jumps_.size() > max_kinks) return {.jumps = {}, .kinks = {}, .too_many = true};
    return {.jumps = jumps_, .kinks = kinks_, .too_many = false};
  }

 private:
  struct Jump {
    double time, size;
  };

  double value(double t) {
    ++n_evaluations_;
    double result = course_(t);
    // A root of a negative number, say: where it begins to have a value counts as a jump.
    if (!std::isfinite(result)) result = 0;
    for (const Jump& jump : subtracted_)
      if (t >= jump.time) result -= jump.size;
    return result;
  }

  Grid samples() {
    Grid grid;
    const double step = (end_ - begin_) / n_samples_;
    double first = std::max(begin_ - 5 * step, first_sample * end_);
    if (begin_ == 0) {
      for (double t = first_sample * end_; t * (log_ratio - 1) < step; t *= log_ratio) grid.t.push_back(t);
      first = grid.t.back() + step;
    }
    for (int i = 0; grid.t.empty() || grid.t.back() <= end_ + 5 * step; ++i) grid.t.push_back(first + step * i);
    while (grid.t.back() > end_ && !std::isfinite(course_(grid.t.back()))) grid.t.pop_back();
    for (const double t : grid.t) grid.v.push_back(value(t));
    return grid;
  }

  double noise(const Grid& grid, std::size_t j) const {
    double size = std::abs(grid.v[j]) + grid.t[j] * (std::abs(grid.slope(j)) + std::abs(grid.slope(j - 1)));
    for (const Jump& jump : subtracted_) size += std::abs(jump.size);
    return 64 * epsilon * size;
  }

  std::vector<Cluster> clusters(const Grid& grid, double floor) const {
    std::vector<Cluster> found;
    for (std::size_t j = stencil + 1; j + stencil + 1 < grid.t.size(); ++j) {
      const double here = grid.change(j), before = grid.change(j - stencil), after = grid.change(j + stencil);
      const double deviation = std::abs(here - 0.5 * (before + after));
      const double beside = std::max(std::abs(before), std::abs(after));
      if (!(deviation > standing_out * (std::abs(here) + beside)) || std::abs(here) < 0.1 * beside) continue;
      if (deviation * (grid.t[j + 1] - grid.t[j - 1]) < 2 * std::max(floor, noise(grid, j))) continue;
      if (!found.empty() && j <= found.back().last + 2 && j < found.back().first + longest_cluster)
        found.back().last = j;
      else
        found.push_back({j, j});
    }
    return found;
  }

  /// Whether a few of the clusters vanish when looked at closely: a vibration, not a saw.
  bool is_smooth_closer(const Grid& grid, const std::vector<Cluster>& found) {
    std::size_t n_kinks = 0;
    for (std::size_t i = 0; i < trials; ++i) n_kinks += examine(grid, found[i * found.size() / trials], {}, 0) ? 1 : 0;
    kinks_.clear();
    jumps_.clear();
    return n_kinks < trials / 4;
  }

  /// @param strengths  slope changes seen at the coarser levels @returns whether a kink or a jump was found
  bool examine(const Grid& grid, const Cluster& cluster, std::vector<double> strengths, int level) {
    std::size_t j = cluster.first - 1;  // the kink lies behind this node and before the next
    for (std::size_t k = cluster.first; k <= cluster.last; ++k)
      if (grid.strength(k) > grid.strength(j)) j = k;
    const double strength = grid.strength(j), step = grid.t[j + 1] - grid.t[j];
    const bool grows = !strengths.empty() && strength > 3 * strengths.back();
    strengths.push_back(strength);
    const double before = strengths[strengths.size() < 4 ? 0 : strengths.size() - 4];
    if (strengths.size() > 2 && strength < persistent * before) return false;
    if (level > deepest || n_evaluations_ > max_evaluations) return too_many_ = n_evaluations_ > max_evaluations;
    const double begin = grid.t[cluster.first - 1], end = grid.t[cluster.last + 1];
    const std::size_t n = cluster.last - cluster.first + 2;
    if (grows)
      if (const auto jump = bisect(grid.t[j], grid.t[j + 1])) {
        subtracted_.push_back(*jump);
        zoom(begin, end, n, {}, level + 1);  // kinks next to the jump
        subtracted_.pop_back();
        return true;
      }
    const double kink = intersection(grid, j), rounding = noise(grid, j);
    if (strength * step < 2 * finer * rounding || step < 1e-13 * grid.t[j]) {
      const double error = std::max(4 * epsilon * kink, std::min(1e-11 * kink, 8 * rounding / strength));
      add(kinks_, rounded(kink, error));
      return true;
    }
    // A single kink is where the lines on both sides meet, and is looked for there first.
    const double close = std::max(step / 128, 4e-13 * kink);
    const bool single = level > 1 && cluster.last - cluster.first < 2 && close < step / 4;
    if (single && zoom(kink - close, kink + close, 2, strengths, level + 1)) return true;
    return zoom(begin, end, n, strengths, level + 1);
  }

  bool zoom(double begin, double end, std::size_t intervals, const std::vector<double>& strengths, int level) {
    const double step = (end - begin) / static_cast<double>(finer * intervals);
    if (step < 4 * epsilon * end) return false;
    Grid grid;
    for (std::size_t i = 0; i <= finer * intervals + 2 * margin; ++i) {
      grid.t.push_back(begin + step * (static_cast<double>(i) - static_cast<double>(margin)));
      grid.v.push_back(value(grid.t.back()));
    }
    bool found = false;
    for (const Cluster& cluster : clusters(grid, 0)) found = examine(grid, cluster, strengths, level) || found;
    return found;
  }

  /// The intersection of the lines on both sides of the interval behind node j.
  static double intersection(const Grid& grid, std::size_t j) {
    const double left = grid.slope(j - 1), right = grid.slope(j + 1), step = grid.t[j + 1] - grid.t[j];
    const double share = (grid.slope(j) - right) / (left - right);
    return grid.t[j] + step * (std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5);
  }

  /// The jump between two times, recorded, if one makes up most of the change between them.
  std::optional<Jump> bisect(double low, double high) {
    const double first = value(low), last = value(high);
    while (std::nextafter(low, high) < high) {
      const double middle = low + 0.5 * (high - low);
      if (const double at = value(middle); std::abs(at - first) < std::abs(at - last))
        low = middle;
      else
        high = middle;
    }
    const double size = value(high) - value(low);
    const double rounding = 1000 * epsilon * (std::abs(first) + std::abs(last));
    if (!(std::abs(size) > 0.5 * std::abs(last - first)) || std::abs(size) <= rounding) return std::nullopt;
    add(jumps_, rounder(low, high));
    return Jump{high, size};
  }

  void add(std::vector<double>& times, double t) const {
    if (t > 0 && t >= begin_ * (1 - at_border) && t < end_) times.push_back(t);
  }

  const Course& course_;
  double begin_, end_;
  int n_samples_;
  int n_evaluations_ = 0;
  bool too_many_ = false;
  std::vector<double> kinks_, jumps_;
  std::vector<Jump> subtracted_;  // known ones in the interval that is looked at
};

/// Increasing, one of those that differ by rounding alone, none of those in `others`.
void tidy(std::vector<double>& times, double error, const std::vector<double>& others = {}) {
  std::sort(times.begin(), times.end());
  std::vector<double> kept;
  for (const double t : times) {
    const auto other = std::lower_bound(others.begin(), others.end(), t * (1 - error));
    const bool known = other != others.end() && *other <= t * (1 + error);
    if (!known && (kept.empty() || t > kept.back() * (1 + error))) kept.push_back(t);
  }
  times = std::move(kept);
}

}  // namespace

double rounder(double a, double b) {
  return fmt::format("{}", a).size() <= fmt::format("{}", b).size() ? a : b;
}

Discontinuities find_discontinuities(const Course& course, Interval over, int samples) {
  Discontinuities result = Search(course, over, samples).run();
  tidy(result.jumps, 4 * epsilon);
  tidy(result.kinks, 1e-11, result.jumps);
  return result;
}

std::optional<double> jump_between(const Course& course, double low, double high) {
  const double first = course(low), last = course(high);
  if (!(first != last)) return std::nullopt;
  while (std::nextafter(low, high) < high) {
    const double middle = low + 0.5 * (high - low);
    if (const double at = course(middle); std::abs(at - first) < std::abs(at - last))
      low = middle;
    else
      high = middle;
  }
  if (!(std::abs(course(high) - course(low)) > 0.5 * std::abs(last - first))) return std::nullopt;
  return rounder(low, high);
}

double rounded(double value, double error, int most_digits) {
  for (int digits = 1; digits <= most_digits; ++digits)
    if (const double round = std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
        std::abs(round - value) <= error)
      return round;
  return value;
}

}  // namespace creepcontact::model
