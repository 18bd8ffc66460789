/// Distributions against their closed forms.
#include "creepcontact/statistics/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace creepcontact::statistics {
namespace {

TEST(Distributions, MedianAndOneDeviation) {
  EXPECT_DOUBLE_EQ(value_at(Normal{10, 2}, 1.5), 13);
  EXPECT_DOUBLE_EQ(value_at(Lognormal{2e-18, 3}, 0), 2e-18);
  EXPECT_DOUBLE_EQ(value_at(Lognormal{2e-18, 3}, -2), 2e-18 / 9);
  EXPECT_DOUBLE_EQ(value_at(Uniform{2, 6}, 0), 4);
  EXPECT_DOUBLE_EQ(value_at(Triangular{0, 1, 1}, 0), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(value_at(Triangular{0, 0, 1}, 0), 1 - std::sqrt(0.5));
}

TEST(Distributions, ProbabilityIsTheInverse) {
  const Table curve{{1, 2, 4}, {0, 0.25, 1}, true};
  for (const Distribution& one :
       {Distribution(Normal{1, 3}), Distribution(Lognormal{5, 1.5}), Distribution(Uniform{-1, 3}),
        Distribution(Triangular{1, 1.5, 4}), Distribution(curve)})
    for (const double z : {-2.5, -1.0, -0.1, 0.0, 0.8, 2.0})
      EXPECT_NEAR(probability_below(one, value_at(one, z)), normal_probability(z), 1e-12) << one.index() << ' ' << z;
}

TEST(Distributions, NothingBeyondTheEnds) {
  EXPECT_EQ(probability_below(Uniform{1, 2}, 0.5), 0);
  EXPECT_EQ(probability_below(Triangular{1, 2, 3}, 3.5), 1);
  EXPECT_EQ(probability_below(Lognormal{1, 2}, 0), 0);
  EXPECT_EQ(probability_below(Lognormal{1, 2}, -1), 0);
}

TEST(Distributions, MeasuredValuesByTheirShares) {
  const Table measured{{10, 20, 30}, {0.5, 0.75, 1}, false};
  EXPECT_EQ(value_at(measured, normal_score(0.49)), 10);
  EXPECT_EQ(value_at(measured, normal_score(0.51)), 20);
  EXPECT_EQ(value_at(measured, normal_score(0.9999)), 30);
  EXPECT_EQ(probability_below(measured, 20), 0.75);
  EXPECT_EQ(probability_below(measured, 19), 0.5);
}

TEST(Distributions, ScoresOfTheNormalDistribution) {
  EXPECT_NEAR(normal_score(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_probability(-5), 2.866515718791939e-7, 1e-20);
}

}  // namespace
}  // namespace creepcontact::statistics
