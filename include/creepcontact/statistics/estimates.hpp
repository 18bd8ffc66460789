#pragma once
/// What a sample tells of the distribution that it is drawn from.

#include <cstddef>
#include <optional>
#include <vector>

namespace creepcontact::statistics {

/// The level of all bounds: they hold the true value with this probability if the sample is one of independent points.
inline constexpr double confidence = 0.95;

/// Quantile of a sample by linear interpolation, the i-th of n values being that of probability (i - 1/2)/n (definition
/// 5 of Hyndman and Fan, The American Statistician 50, 1996). @param sorted  ascending, at least one
double quantile(const std::vector<double>& sorted, double probability);

/// Positions in the sorted sample between which the quantile lies, by the binomial distribution of the number of
/// smaller values (David and Nagaraja, Order Statistics, 2003, section 7.1). nullopt: the sample is too small.
struct QuantileBounds {
  std::optional<std::size_t> low, high;
};
QuantileBounds quantile_bounds(std::size_t n, double probability);

/// A share of a sample with its bounds of Clopper and Pearson (Biometrika 26, 1934).
struct Proportion {
  double value = 0, low = 0, high = 1;
};
/// @param n  at least 1
Proportion proportion(std::size_t found, std::size_t n);

/// Ranks from 1; equal values have the mean of their ranks.
std::vector<double> ranks(const std::vector<double>& values);

/// Spearman's rank correlation of the pairs without NaN; NaN if there are fewer than three, or one list is constant.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace creepcontact::statistics
