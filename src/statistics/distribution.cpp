#include "creepcontact/statistics/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "creepcontact/base/overload.hpp"

namespace creepcontact::statistics {
namespace {

double value_in(const Triangular& triangle, double p) {
  const double width = triangle.max - triangle.min, left = triangle.mode - triangle.min,
               right = triangle.max - triangle.mode;
  return p * width < left ? triangle.min + std::sqrt(p * width * left)
                          : triangle.max - std::sqrt((1 - p) * width * right);
}

double value_in(const Table& table, double p) {
  const auto found = std::ranges::lower_bound(table.cumulative, p);
  const auto i = std::min(static_cast<std::size_t>(found - table.cumulative.begin()), table.values.size() - 1);
  if (!table.is_continuous || i == 0) return table.values[i];
  const double below = table.cumulative[i - 1], step = table.cumulative[i] - below;
  const double share = step > 0 ? (p - below) / step : 1;
  return table.values[i - 1] + share * (table.values[i] - table.values[i - 1]);
}

double probability_in(const Triangular& triangle, double x) {
  if (x <= triangle.min) return 0;
  if (x >= triangle.max) return 1;
  const double width = triangle.max - triangle.min;
  if (x < triangle.mode) return (x - triangle.min) * (x - triangle.min) / (width * (triangle.mode - triangle.min));
  return 1 - (triangle.max - x) * (triangle.max - x) / (width * (triangle.max - triangle.mode));
}

double probability_in(const Table& table, double x) {
  const auto after = std::ranges::upper_bound(table.values, x);
  if (after == table.values.begin()) return 0;
  const auto i = static_cast<std::size_t>(after - table.values.begin()) - 1;
  if (!table.is_continuous || i + 1 == table.values.size()) return table.cumulative[i];
  const double share = (x - table.values[i]) / (table.values[i + 1] - table.values[i]);
  return table.cumulative[i] + share * (table.cumulative[i + 1] - table.cumulative[i]);
}

}  // namespace

double normal_probability(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

double normal_score(double p) {
  return boost::math::quantile(boost::math::normal_distribution<double>(), p);
}

double value_at(const Distribution& distribution, double score) {
  return std::visit(
      Overload{[&](const Normal& one) { return one.mean + one.deviation * score; },
               [&](const Lognormal& one) { return one.median * std::pow(one.factor, score); },
               [&](const Uniform& one) { return one.min + normal_probability(score) * (one.max - one.min); },
               [&](const Triangular& one) { return value_in(one, normal_probability(score)); },
               [&](const Table& one) { return value_in(one, normal_probability(score)); }},
      distribution);
}

double probability_below(const Distribution& distribution, double x) {
  return std::visit(
      Overload{[&](const Normal& one) { return normal_probability((x - one.mean) / one.deviation); },
               [&](const Lognormal& one) {
                 return x > 0 ? normal_probability(std::log(x / one.median) / std::log(one.factor)) : 0;
               },
               [&](const Uniform& one) { return std::clamp((x - one.min) / (one.max - one.min), 0.0, 1.0); },
               [&](const Triangular& one) { return probability_in(one, x); },
               [&](const Table& one) { return probability_in(one, x); }},
      distribution);
}

}  // namespace creepcontact::statistics
