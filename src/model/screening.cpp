#include "screening.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace creepcontact::model {
namespace {

constexpr double fewest_times = 64, most_times = 4096;
constexpr double unexplained = 0.1;  // deviation from the mean of the neighbouring values, over the range

}  // namespace

Screening::Screening(const FunctionCourses& function, const Places& places, double end, double evaluations)
    : end_(end) {
  const double n_all = static_cast<double>(places.size());
  n_times_ = static_cast<std::size_t>(std::clamp(evaluations / n_all, fewest_times, most_times));
  const double stride = std::max(1.0, n_all * static_cast<double>(n_times_) / evaluations);
  for (double i = 0; i < n_all; i += stride) places_.push_back(static_cast<std::size_t>(i));
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t row = 0; row < places_.size(); ++row) {
    const Place& place = places[places_[row]];
    const Course course = function.at(place, function.levels(place).front());
    for (std::size_t i = 0; i < n_times_; ++i) {
      double v = course(time(row, i));
      if (!std::isfinite(v)) v = 0;
      low = std::min(low, v);
      high = std::max(high, v);
      values_.push_back(v);
    }
  }
  range_ = high - low;
  taken_.resize(places_.size(), false);
}

double Screening::time(std::size_t row, std::size_t i) const {
  const double shift = std::fmod(static_cast<double>(row) * std::numbers::phi, 1.0);
  return end_ * (static_cast<double>(i) + shift) / static_cast<double>(n_times_);
}

std::optional<std::size_t> Screening::next(const std::vector<double>& known) {
  double largest = unexplained * range_;
  std::optional<std::size_t> found;
  for (std::size_t row = 0; row < places_.size(); ++row) {
    if (taken_[row]) continue;
    const double* const v = values_.data() + row * n_times_;
    for (std::size_t i = 1; i + 1 < n_times_; ++i) {
      const double deviation = std::abs(v[i] - 0.5 * (v[i - 1] + v[i + 1]));
      if (!(deviation > largest)) continue;
      const auto after = std::ranges::lower_bound(known, time(row, i - 1));
      if (after != known.end() && *after <= time(row, i + 1)) continue;
      largest = deviation;
      found = row;
    }
  }
  if (!found) return std::nullopt;
  taken_[*found] = true;
  return places_[*found];
}

}  // namespace creepcontact::model
