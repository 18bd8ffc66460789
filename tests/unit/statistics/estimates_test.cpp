/// Quantiles and their bounds, proportions, ranks and shares of variance against tables and closed forms.
#include "creepcontact/statistics/estimates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/statistics/distribution.hpp"
#include "creepcontact/statistics/sampling.hpp"
#include "creepcontact/statistics/variance_shares.hpp"

namespace creepcontact::statistics {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Quantiles, MiddlesOfTheSteps) {
  const std::vector<double> sample{1, 2, 3, 10};
  EXPECT_DOUBLE_EQ(quantile(sample, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.125), 1);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.75), 6.5);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.01), 1);
  EXPECT_DOUBLE_EQ(quantile(sample, 0.99), 10);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.3), 7);
}

TEST(Quantiles, BoundsOfTheMedianAsInTables) {
  // Conover, Practical Nonparametric Statistics: 95 % for the median of 100 values from the 40th to the 61st
  const QuantileBounds bounds = quantile_bounds(100, 0.5);
  EXPECT_EQ(bounds.low, 39u);
  EXPECT_EQ(bounds.high, 60u);
}

TEST(Quantiles, SmallSamplesDoNotBoundTails) {
  EXPECT_FALSE(quantile_bounds(71, 0.95).high);  // 0.95^71 > 0.025 > 0.95^72
  EXPECT_EQ(quantile_bounds(72, 0.95).high, 71u);
  EXPECT_FALSE(quantile_bounds(71, 0.05).low);
  EXPECT_EQ(quantile_bounds(72, 0.05).low, 0u);
}

TEST(Quantiles, BoundsHoldTheTrueValueAsOftenAsTheySay) {
  int held = 0;
  constexpr int trials = 2000;
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    auto sample = uniform_points(SamplingMethod::monte_carlo, seed, 200, 1);
    std::ranges::sort(sample);
    const QuantileBounds bounds = quantile_bounds(200, 0.9);
    held += sample[*bounds.low] <= 0.9 && 0.9 <= sample[*bounds.high];
  }
  EXPECT_GT(held, 0.945 * trials);
  EXPECT_LT(held, 0.985 * trials);
}

TEST(Proportions, ClopperAndPearson) {
  const Proportion none = proportion(0, 10), half = proportion(5, 10), all = proportion(10, 10);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 1 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_NEAR(half.low, 0.18708603, 1e-8);
  EXPECT_NEAR(half.high, 0.81291397, 1e-8);
  EXPECT_NEAR(all.low, std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(all.high, 1);
}

TEST(Ranks, TiesShareTheirRanks) {
  EXPECT_EQ(ranks({30, 10, 20, 10}), (std::vector<double>{4, 1.5, 3, 1.5}));
}

TEST(Ranks, CorrelationOfMonotoneFunctions) {
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, 3, 4}, {1, 8, 27, 1000}), 1);
  EXPECT_DOUBLE_EQ(rank_correlation({1, 2, nan, 4, 5}, {4, 3, 9, 1, nan}), -1);
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2, 3}, {5, 5, 5})));
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2}, {1, 2})));
}

class Shares : public testing::Test {
 protected:
  template <class Function>
  VarianceShares of(std::size_t n, const std::vector<Basis>& bases, Function function) const {
    const auto scores = normal_points(SamplingMethod::sobol, 1, n, bases.size());
    std::vector<double> results;
    for (std::size_t i = 0; i < n; ++i) results.push_back(function(&scores[i * bases.size()]));
    return variance_shares(scores, bases, results);
  }
  const Basis score = Basis::normal_score, probability = Basis::probability;
};

TEST_F(Shares, OfAPolynomial) {
  const auto shares = of(256, {score, score}, [](const double* z) { return 5 + 2 * z[0] + z[1] + z[0] * z[1]; });
  EXPECT_NEAR(shares.first_order[0], 4.0 / 6, 0.02);
  EXPECT_NEAR(shares.first_order[1], 1.0 / 6, 0.02);
  EXPECT_NEAR(shares.interactions, 1.0 / 6, 0.02);
  EXPECT_NEAR(shares.quality, 1, 1e-9);
  EXPECT_EQ(shares.degree, 2);
}

TEST_F(Shares, OfProbabilities) {
  const auto shares = of(512, {probability, score},
                         [](const double* z) { return std::sqrt(12.0) * normal_probability(z[0]) + 2 * z[1]; });
  EXPECT_NEAR(shares.first_order[0], 0.2, 0.005);
  EXPECT_NEAR(shares.first_order[1], 0.8, 0.005);
}

TEST_F(Shares, QualityTellsWherePolynomialsDoNotDescribeTheResult) {
  const auto shares = of(256, {score, score}, [](const double* z) { return std::sin(7 * z[0]) * z[1]; });
  EXPECT_LT(shares.quality, 0.3);
}

TEST_F(Shares, NoneOfTooFewPoints) {
  EXPECT_TRUE(of(5, {score, score}, [](const double* z) { return z[0]; }).first_order.empty());
  EXPECT_TRUE(of(64, {score}, [](const double*) { return 1.0; }).first_order.empty());
}

}  // namespace
}  // namespace creepcontact::statistics
