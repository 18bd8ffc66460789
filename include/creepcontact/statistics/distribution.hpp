#pragma once
/// Distributions of one number, as functions of a standard normal score: the value at score z is exceeded with the
/// probability with which a standard normal variable exceeds z.

#include <variant>
#include <vector>

namespace creepcontact::statistics {

struct Normal {
  double mean = 0, deviation = 1;
};
/// Its logarithm is normal: mean ln(median), standard deviation ln(factor).
struct Lognormal {
  double median = 1, factor = 2;
};
struct Uniform {
  double min = 0, max = 1;
};
struct Triangular {
  double min = 0, mode = 0.5, max = 1;
};
/// Values in ascending order. Each occurs with its share, the increase of `cumulative` up to it; or, if the table is
/// continuous, the probability grows linearly from value to value, beginning with 0.
struct Table {
  std::vector<double> values;
  std::vector<double> cumulative;  ///< probability of at most this value; ends with 1
  bool is_continuous = false;
};

using Distribution = std::variant<Normal, Lognormal, Uniform, Triangular, Table>;

/// Standard normal distribution: probability of at most z, and its inverse for 0 < p < 1.
double normal_probability(double z);
double normal_score(double p);

/// The value at a score. Cost: a microsecond.
double value_at(const Distribution& distribution, double score);

/// Probability of a value of at most x.
double probability_below(const Distribution& distribution, double x);

}  // namespace creepcontact::statistics
