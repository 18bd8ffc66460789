#include "course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "values.hpp"

namespace creepcontact::deck {

void Course::add(double time, double value) {
  if (!points_.empty() && points_.back() == std::pair(time, value)) return;
  points_.emplace_back(time, value);
}

bool Course::is_zero() const {
  return std::ranges::all_of(points_, [](const auto& point) { return point.second == 0; });
}

double Course::at(double time) const {
  const auto points = tidied();
  for (std::size_t i = points.size(); i-- > 0;) {
    if (time < points[i].first) continue;
    if (i + 1 == points.size()) return points[i].second;
    const double part = (time - points[i].first) / (points[i + 1].first - points[i].first);
    return points[i].second + part * (points[i + 1].second - points[i].second);
  }
  return points.empty() ? 0 : points.front().second;
}

double Course::before(double time) const {
  const auto points = tidied();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].first < time) continue;
    if (i == 0) return points.front().second;
    const double part = (time - points[i - 1].first) / (points[i].first - points[i - 1].first);
    return points[i - 1].second + part * (points[i].second - points[i - 1].second);
  }
  return points.empty() ? 0 : points.back().second;
}

Course Course::plus(const Course& other) const {
  std::set<double> times;
  for (const Course* course : {this, &other})
    for (const auto& [time, value] : course->points_) times.insert(time);
  Course sum;
  for (const double time : times) {
    sum.add(time, before(time) + other.before(time));
    sum.add(time, at(time) + other.at(time));
  }
  return sum;
}

bool Course::is_constant() const {
  return std::ranges::all_of(points_, [&](const auto& point) { return point.second == points_.front().second; });
}

Course Course::scaled(double factor) const {
  Course result = *this;
  for (auto& [time, value] : result.points_) value *= factor;
  return result;
}

/// Keeps at most two points at one time; what happens within t = 0 has happened before the run.
std::vector<std::pair<double, double>> Course::tidied() const {
  std::vector<std::pair<double, double>> result;
  for (const auto& point : points_) {
    const std::size_t n = result.size();
    if (point.first == 0 && n == 1) {
      result.back() = point;
      continue;
    }
    if (n >= 2 && result[n - 1].first == point.first && result[n - 2].first == point.first)
      result.back() = point;
    else
      result.push_back(point);
  }
  return result;
}

Function Course::function() const {
  if (points_.empty() || is_constant()) return rounded(last());
  std::vector<double> times, values;
  for (const auto& [time, value] : tidied()) {
    times.push_back(rounded(time));
    values.push_back(rounded(value));
  }
  return Function::table("t", std::move(times), std::move(values));
}

Function Course::function(const std::string& wrap) const {
  const auto of_time = [&](const std::string& value) {
    return Function::expression(fmt::format("{}({})", wrap, value), {"t"});
  };
  if (points_.empty() || is_constant()) return of_time(fmt::format("{:.15g}", last()));
  const auto points = tidied();
  std::string text = fmt::format("{:.15g}", points.back().second);
  for (std::size_t i = points.size(); i-- > 1;) {
    const auto [t0, v0] = points[i - 1];
    const auto [t1, v1] = points[i];
    const std::string piece = t1 > t0 ? fmt::format("{:.15g} + {:.15g}*(t - {:.15g})", v0, (v1 - v0) / (t1 - t0), t0)
                                      : fmt::format("{:.15g}", v0);
    text = fmt::format("(t < {:.15g} ? {} : {})", t1, piece, text);
  }
  return of_time(fmt::format("max(0, {})", text));
}

}  // namespace creepcontact::deck
