#include "point_merging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "creepcontact/base/log.hpp"

namespace creepcontact::io {

PointTemperatures merged(PointTemperatures read, const std::string& file, const std::string& of) {
  const std::vector<Vector3>& points = read.points;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(points[a].begin(), points[a].end(), points[b].begin(), points[b].end());
  });
  PointTemperatures result;
  result.has_times = read.has_times;
  result.times = read.times;
  result.values.resize(read.values.size());
  double largest_difference = 0;
  std::size_t n_different = 0;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && points[order[end]] == points[order[begin]]) ++end;
    result.points.push_back(points[order[begin]]);
    double difference = 0;
    for (std::size_t t = 0; t < read.values.size(); ++t) {
      double sum = 0, low = read.values[t][order[begin]], high = low;
      for (std::size_t i = begin; i < end; ++i) {
        const double value = read.values[t][order[i]];
        sum += value;
        low = std::min(low, value);
        high = std::max(high, value);
      }
      result.values[t].push_back(low == high ? low : sum / static_cast<double>(end - begin));
      difference = std::max(difference, high - low);
    }
    if (difference > 0) ++n_different;
    largest_difference = std::max(largest_difference, difference);
  }
  if (n_different > 0)
    log::warning(
        "{}: '{}' has different values at {} of {} places, where nodes coincide (by up to {:.4g}); their mean is used",
        of, file, n_different, result.points.size(), largest_difference);
  return result;
}

}  // namespace creepcontact::io
