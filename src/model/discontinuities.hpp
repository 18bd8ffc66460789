#pragma once
/// Where a function of time has kinks or jumps: the integration stops there and restarts.

#include <functional>
#include <optional>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::model {

/// A function of the configuration as it depends on the time alone: at some place, temperature, stress and strain.
using Course = std::function<double(double t)>;

struct Discontinuities {
  std::vector<double>
      jumps;  ///< the double at which the value changes, or its neighbour if that is rounder; increasing
  std::vector<double> kinks;  ///< where the slope jumps or is infinite, to about 1e-12 relative; increasing
  bool too_many = false;      ///< there are more than can be found: both lists are empty
};

/// Uniformly spaced samples of a whole run. A prime: no period divides their distance.
constexpr int run_samples = 16381;

/// The discontinuities in an interval that begins at 0 or later, from uniformly spaced samples. If the interval begins
/// at 0, there are also logarithmically spaced samples near 0. A feature is seen if it is wider than the interval over
/// the number of samples, or, near 0, than 2 % of the time. Where the function is NaN or infinite it counts as 0.
/// Cost: an evaluation per sample, some 700 more at 0, and some hundreds per kink.
Discontinuities find_discontinuities(const Course& course, Interval over, int samples = run_samples);

/// The jump between two times, as in Discontinuities::jumps, if one makes up most of the change between them.
std::optional<double> jump_between(const Course& course, double low, double high);

/// The number with fewer digits: expressions are written with round numbers.
double rounder(double a, double b);

/// The decimal number of the fewest digits within an error: expressions are written with round numbers.
double rounded(double value, double error, int most_digits = 12);

}  // namespace creepcontact::model
