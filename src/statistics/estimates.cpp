#include "creepcontact/statistics/estimates.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace creepcontact::statistics {
namespace {

using Binomial = boost::math::binomial_distribution<double>;
constexpr double one_side = 0.5 * (1 - confidence);

/// Pearson's correlation.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double quantile(const std::vector<double>& sorted, double probability) {
  const double position = static_cast<double>(sorted.size()) * probability - 0.5;
  if (position <= 0) return sorted.front();
  const auto i = static_cast<std::size_t>(position);
  if (i + 1 >= sorted.size()) return sorted.back();
  return std::lerp(sorted[i], sorted[i + 1], position - static_cast<double>(i));
}

QuantileBounds quantile_bounds(std::size_t n, double probability) {
  const Binomial smaller(static_cast<double>(n), probability);
  std::vector<std::size_t> counts(n);  // of smaller values
  std::iota(counts.begin(), counts.end(), std::size_t{0});
  const auto at_most = [&](double level) {
    return std::ranges::partition_point(
        counts, [&](std::size_t k) { return boost::math::cdf(smaller, static_cast<double>(k)) <= level; });
  };
  QuantileBounds bounds;
  if (const auto end = at_most(one_side); end != counts.begin()) bounds.low = *std::prev(end);
  if (const auto end = at_most(1 - one_side); end != counts.end()) bounds.high = *end;
  return bounds;
}

Proportion proportion(std::size_t found, std::size_t n) {
  const auto k = static_cast<double>(found), all = static_cast<double>(n);
  return {k / all, found == 0 ? 0 : Binomial::find_lower_bound_on_p(all, k, one_side),
          found == n ? 1 : Binomial::find_upper_bound_on_p(all, k, one_side)};
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> all(values.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    const double mean = 0.5 * static_cast<double>(begin + 1 + end);
    for (std::size_t i = begin; i < end; ++i) all[order[i]] = mean;
  }
  return all;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> known_a, known_b;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i])) continue;
    known_a.push_back(a[i]);
    known_b.push_back(b[i]);
  }
  constexpr std::size_t least = 3;
  if (known_a.size() < least) return std::numeric_limits<double>::quiet_NaN();
  return correlation(ranks(known_a), ranks(known_b));
}

}  // namespace creepcontact::statistics
