#include "temperature_passages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace creepcontact::model {
namespace {

constexpr std::size_t spread_places = 8, few_pieces = 2000, many_pieces = 40000;
constexpr std::size_t few_passages = 300, most_passages = 100000;
constexpr double weak = 0.02;    // change of the value without the point, of the value
constexpr double margin = 0.05;  // of the range of temperatures
constexpr int samples_per_piece = 4;

struct Point {
  double T = 0;
  double strength = 0;  ///< change of the value if the point were not there, relative; a jump: infinite
};

/// Times and temperatures between which one place's temperature is taken to be monotonous.
struct Path {
  Course temperature;
  std::vector<double> t, T;
};

class Passages {
 public:
  Passages(const FunctionCourses& function, const Places& places, const std::vector<double>& pieces)
      : function_(function), places_(places), pieces_(pieces) {
    const std::size_t n = function.depends_on_place() && pieces.size() < many_pieces ? spread_places : 1;
    for (const std::size_t i : spread(places, n)) {
      paths_.push_back(path(places[i]));
      if (!function.depends_on_place() || pieces.size() >= many_pieces) break;
    }
    for (const Path& path : paths_)
      for (const double T : path.T) {
        if (!std::isfinite(T)) continue;
        low_ = std::min(low_, T);
        high_ = std::max(high_, T);
      }
  }

  TemperaturePassages all() const {
    if (!(high_ > low_)) return {};
    std::vector<Point> points = points_of_function();
    TemperaturePassages result{at(points)};
    if (result.times.size() > few_passages) {
      std::erase_if(points, [](const Point& point) { return point.strength < weak; });
      result.times = at(points);
    }
    if (result.times.size() > most_passages) {
      std::ranges::sort(points, std::greater(), &Point::strength);
      while (!points.empty() && result.times.size() > most_passages) {
        result.missing = points.back().strength;
        points.pop_back();
        result.times = at(points);
      }
    }
    return result;
  }

 private:
  Path path(const Place& place) const {
    Path result{function_.temperature(place), {}, {}};
    const int n = pieces_.size() < few_pieces ? samples_per_piece : 1;
    for (std::size_t i = 1; i < pieces_.size(); ++i) {
      // Neither end itself: the temperature may jump there.
      const double begin = pieces_[i - 1], width = pieces_[i] - begin, inside = 1e-9 * width;
      for (int k = 0; k <= n; ++k)
        result.t.push_back(std::clamp(begin + width * k / n, begin + inside, pieces_[i] - inside));
    }
    for (const double t : result.t) result.T.push_back(result.temperature(t));
    return result;
  }

  std::vector<Point> points_of_function() const {
    const double width = high_ - low_, from = low_ - margin * width;
    const Place& place = places_.front();
    const Level level = function_.levels(place).front();
    const Course value = [&](double s) { return function_.at_temperature(place, level, from + s); };
    const Discontinuities found = find_discontinuities(value, {0, (1 + 2 * margin) * width});
    std::vector<Point> points;
    for (const double s : found.jumps) points.push_back({from + s, HUGE_VAL});
    for (const double s : found.kinks) points.push_back({from + s, 0});
    std::ranges::sort(points, {}, &Point::T);
    for (std::size_t i = 0; i < points.size(); ++i) {
      Point& point = points[i];
      point.T = rounded(point.T, 1e-11 * (std::abs(point.T) + width));
      if (point.strength > 0) continue;
      const double before = i > 0 ? points[i - 1].T : from;
      const double after = i + 1 < points.size() ? points[i + 1].T : high_ + margin * width;
      const auto at = [&](double T) { return function_.at_temperature(place, level, T); };
      const double share = (point.T - before) / (after - before);
      const double chord = at(before) + share * (at(after) - at(before)), own = at(point.T);
      point.strength = std::abs(own - chord) / std::max({std::abs(own), std::abs(chord), 1e-300});
    }
    return points;
  }

  std::vector<double> at(const std::vector<Point>& points) const {
    std::set<double> result;
    for (const Point& point : points) {
      std::map<std::size_t, std::vector<double>> by_number;  // the first passage of all places, the second ...
      for (const Path& path : paths_) {
        const std::vector<double> own = passages(path, point.T);
        for (std::size_t i = 0; i < own.size(); ++i) by_number[i].push_back(own[i]);
      }
      for (auto& [number, times] : by_number) {
        std::ranges::sort(times);
        constexpr std::size_t kept = 5;
        const std::size_t n = std::min(kept, times.size());
        for (std::size_t i = 0; i < n; ++i) result.insert(times[n == 1 ? 0 : i * (times.size() - 1) / (n - 1)]);
      }
    }
    return {result.begin(), result.end()};
  }

  static std::vector<double> passages(const Path& path, double T) {
    std::vector<double> result;
    for (std::size_t i = 1; i < path.t.size(); ++i) {
      double before = path.t[i - 1], after = path.t[i];
      const double at_before = path.T[i - 1] - T, at_after = path.T[i] - T;
      if (!(at_before * at_after < 0) && !(at_after == 0 && at_before != 0)) continue;
      for (int halving = 0; halving < 80; ++halving) {
        const double middle = 0.5 * (before + after);
        if (middle <= before || middle >= after) break;
        const double there = path.temperature(middle) - T;
        (there * at_before > 0 ? before : after) = middle;
      }
      result.push_back(rounded(after, 1e-13 * after));
    }
    return result;
  }

  const FunctionCourses& function_;
  const Places& places_;
  const std::vector<double>& pieces_;
  std::vector<Path> paths_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

TemperaturePassages temperature_passages(const FunctionCourses& function, const Places& places,
                                         const std::vector<double>& pieces) {
  return Passages(function, places, pieces).all();
}

}  // namespace creepcontact::model
