/// Points in the hypercube: strata, nets, moments, and that they are the same wherever and however many are drawn.
#include "creepcontact/statistics/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "creepcontact/statistics/distribution.hpp"
#include "creepcontact/statistics/estimates.hpp"

namespace creepcontact::statistics {
namespace {

std::vector<double> coordinate(const std::vector<double>& points, std::size_t dimensions, std::size_t d) {
  std::vector<double> values;
  for (std::size_t i = d; i < points.size(); i += dimensions) values.push_back(points[i]);
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

void expect_one_a_stratum(const std::vector<double>& values) {
  std::set<int> strata;
  for (const double value : values) {
    EXPECT_TRUE(value > 0 && value < 1);
    strata.insert(static_cast<int>(value * static_cast<double>(values.size())));
  }
  EXPECT_EQ(strata.size(), values.size());
}

TEST(Sobol, OnePointInEachStratumOfEveryCoordinate) {
  constexpr std::size_t dimensions = 20;
  for (const std::uint64_t seed : {0u, 1u, 7u}) {
    const auto points = uniform_points(SamplingMethod::sobol, seed, 256, dimensions);
    for (std::size_t d = 0; d < dimensions; ++d) expect_one_a_stratum(coordinate(points, dimensions, d));
  }
}

TEST(Sobol, TheFirstTwoCoordinatesAreANet) {
  const auto points = uniform_points(SamplingMethod::sobol, 3, 64, 2);
  for (const int columns : {1, 2, 4, 8, 16, 32, 64}) {  // every box of area 1/64 has one point
    const int rows = 64 / columns;
    std::set<int> boxes;
    for (std::size_t i = 0; i < 64; ++i)
      boxes.insert(static_cast<int>(points[2 * i] * columns) * rows + static_cast<int>(points[2 * i + 1] * rows));
    EXPECT_EQ(boxes.size(), 64u) << columns;
  }
}

TEST(Sobol, ScramblingDependsOnTheSeedAndIsUniform) {
  const auto first = [](std::uint64_t seed) { return uniform_points(SamplingMethod::sobol, seed, 1, 1).front(); };
  std::vector<double> values;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) values.push_back(first(seed));
  std::ranges::sort(values);
  for (std::size_t i = 0; i < values.size(); ++i)  // Kolmogorov's statistic at 0.1 %
    EXPECT_NEAR(values[i], (static_cast<double>(i) + 0.5) / 1000, 1.95 / std::sqrt(1000.0));
}

TEST(Sobol, IntegratesFarBetterThanIndependentPoints) {
  const auto error = [](SamplingMethod method) {  // of the mean of a product of five coordinates, 2^-5
    double square = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto points = uniform_points(method, seed, 1024, 5);
      double sum = 0;
      for (std::size_t i = 0; i < points.size(); i += 5)
        sum += points[i] * points[i + 1] * points[i + 2] * points[i + 3] * points[i + 4];
      square += std::pow(sum / 1024 - 1.0 / 32, 2);
    }
    return std::sqrt(square / 20);
  };
  EXPECT_LT(error(SamplingMethod::sobol), 0.05 * error(SamplingMethod::monte_carlo));
}

TEST(LatinHypercube, OnePointInEachStratumOfEveryCoordinate) {
  const auto points = uniform_points(SamplingMethod::latin_hypercube, 1, 100, 5);
  for (std::size_t d = 0; d < 5; ++d) expect_one_a_stratum(coordinate(points, 5, d));
  EXPECT_LT(std::abs(rank_correlation(coordinate(points, 5, 0), coordinate(points, 5, 1))), 0.3);
  EXPECT_NE(points, uniform_points(SamplingMethod::latin_hypercube, 2, 100, 5));
}

TEST(MonteCarlo, MomentsOfNormalScores) {
  const auto points = normal_points(SamplingMethod::monte_carlo, 1, 40'000, 1);
  EXPECT_NEAR(mean(points), 0, 0.02);
  double square = 0, fourth = 0;
  for (const double z : points) {
    square += z * z;
    fourth += z * z * z * z;
  }
  EXPECT_NEAR(square / 40'000, 1, 0.03);
  EXPECT_NEAR(fourth / 40'000, 3, 0.25);
}

TEST(Sampling, MorePointsBeginWithTheSame) {
  for (const SamplingMethod method : {SamplingMethod::sobol, SamplingMethod::monte_carlo}) {
    const auto few = normal_points(method, 5, 37, 3), many = normal_points(method, 5, 500, 3);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  }
}

TEST(Sampling, IsTheSameEverywhere) {
  const auto expect_points = [](SamplingMethod method, const std::vector<double>& expected) {
    const auto points = uniform_points(method, 1, 2, 2);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(points[i], expected[i]);
  };
  expect_points(SamplingMethod::sobol,
                {0.86019268061500043, 0.92166544741485268, 0.006899134605191648, 0.16392662015277892});
  expect_points(SamplingMethod::latin_hypercube,
                {0.26611582515202892, 0.37306425462266002, 0.98553100258731208, 0.96415450386583434});
  expect_points(SamplingMethod::monte_carlo,
                {0.53246524338255163, 0.89269856320577556, 0.89049588741896235, 0.55531912817049389});
}

TEST(Correlation, OfNormalScores) {
  const std::vector<double> matrix{1, 0.6, -0.3, 0.6, 1, 0, -0.3, 0, 1};
  const auto factor = correlation_factor(matrix, 3);
  ASSERT_EQ(factor.size(), 9u);
  auto points = normal_points(SamplingMethod::sobol, 1, 4096, 3);
  correlate(points, factor, 3);
  for (const auto& [a, b, expected] : {std::tuple(0, 1, 0.6), std::tuple(0, 2, -0.3), std::tuple(1, 2, 0.0)}) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); i += 3)
      sum += points[i + static_cast<std::size_t>(a)] * points[i + static_cast<std::size_t>(b)];
    EXPECT_NEAR(sum / 4096, expected, 0.01);
  }
}

TEST(Correlation, MustBePositiveDefinite) {
  EXPECT_TRUE(correlation_factor({1, 0.9, -0.9, 0.9, 1, 0.9, -0.9, 0.9, 1}, 3).empty());
  EXPECT_TRUE(correlation_factor({1, 1, 1, 1}, 2).empty());
}

}  // namespace
}  // namespace creepcontact::statistics
