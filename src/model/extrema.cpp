#include "extrema.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::model {
namespace {

constexpr int samples = 2000;
constexpr double min_turn = 0.01;
constexpr std::size_t most = 100;

}  // namespace

double extremum_error(double end) {
  return end / samples;
}

std::vector<double> extrema(const Function& function, double end) {
  if (!function.depends_on_time() || !function.breakpoints().empty()) return {};
  std::vector<double> values;
  for (int i = 0; i <= samples; ++i)  // at a place where no coordinate is zero
    values.push_back(function({.x = 1.0, .y = 0.7, .z = 0.3, .t = end * i / samples}));
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) return {};
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double turn = min_turn * (*largest - *least);
  if (!(turn > 0)) return {};

  std::vector<double> times;
  int direction = 0;        // +1 rising, -1 falling, 0 not known yet
  std::size_t extreme = 0;  // the highest point of a rise, the lowest of a fall
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = values[i] - values[extreme];
    if (direction == 0 ? std::abs(change) <= turn : direction * change > 0) {
      if (direction != 0) extreme = i;
    } else if (std::abs(change) > turn) {
      if (direction != 0) times.push_back(end * static_cast<double>(extreme) / samples);
      direction = change > 0 ? 1 : -1;
      extreme = i;
    }
  }
  return times.size() <= most ? times : std::vector<double>{};
}

}  // namespace creepcontact::model
