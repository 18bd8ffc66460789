/// Interpolation between scattered points.
#include "../../../src/mechanics/scattered_interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace creepcontact::mechanics {
namespace {

using Field = std::function<double(const Vector3&)>;

double interpolated(const std::vector<Vector3>& points, const Field& field, const Vector3& position) {
  double sum = 0;
  for (const PointWeight& term : ScatteredInterpolation(points).weights(position))
    sum += term.weight * field(points[term.point]);
  return sum;
}

std::vector<Vector3> random_points(int n, const Vector3& size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Vector3> points;
  for (int i = 0; i < n; ++i)
    points.emplace_back(size[0] * share(random), size[1] * share(random), size[2] * share(random));
  return points;
}

double linear(const Vector3& x) {
  return 500 + 20 * x[0] - 7 * x[1] + 3 * x[2];
}

TEST(ScatteredInterpolation, IsExactForLinearFieldsAndAtThePoints) {
  const auto points = random_points(500, {2, 1, 4});
  const ScatteredInterpolation interpolation(points);
  for (const Vector3& position : random_points(97, {2, 1, 4}))
    EXPECT_NEAR(interpolated(points, linear, position), 500 + 20 * position[0] - 7 * position[1] + 3 * position[2],
                1e-9);
  for (const std::size_t i : {0u, 100u, 499u}) {
    const auto weights = interpolation.weights(points[i]);
    ASSERT_EQ(weights.size(), 1u);
    EXPECT_EQ(weights[0].point, i);
  }
}

/// Layers far apart, dense in themselves: the nearest points all lie in one of them.
TEST(ScatteredInterpolation, SeesTheNextLayer) {
  std::vector<Vector3> points;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) points.emplace_back(0.05 * i, 0.05 * j, 1.0 * k);
  for (const Vector3& position : {Vector3(0.31, 0.22, 1.4), Vector3(0.02, 0.5, 0.1), Vector3(0.55, 0.55, 2.98)})
    EXPECT_NEAR(interpolated(points, linear, position), linear(position), 1e-9);
}

TEST(ScatteredInterpolation, ErrorFallsWithTheSquareOfTheSpacing) {
  const Field curved = [](const Vector3& x) { return std::sin(x[0]) * std::exp(x[1]) + x[2] * x[2]; };
  std::vector<double> errors;
  for (const int n : {8, 16}) {
    std::vector<Vector3> points;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) points.emplace_back(1.0 * i / n, 1.0 * j / n, 1.0 * k / n);
    double sum = 0;
    const auto positions = random_points(200, {1, 1, 1});
    for (const Vector3& position : positions)
      sum += std::pow(interpolated(points, curved, position) - curved(position), 2);
    errors.push_back(std::sqrt(sum / 200));
  }
  EXPECT_GT(errors[0] / errors[1], 3.2);
  EXPECT_LT(errors[1], 2e-3);
}

TEST(ScatteredInterpolation, IsConstantAcrossPlanesAndLines) {
  std::vector<Vector3> plane, line;
  for (int i = 0; i <= 10; ++i) {
    line.emplace_back(0.1 * i, 0.1 * i, 2);
    for (int j = 0; j <= 10; ++j) plane.emplace_back(0.1 * i, 0.1 * j, 5);
  }
  for (const double z : {-100.0, 5.0, 77.0})
    EXPECT_NEAR(interpolated(plane, linear, {0.33, 0.71, z}), linear({0.33, 0.71, 5}), 1e-9);
  // A line through a wall: the place is taken to its foot point.
  EXPECT_NEAR(interpolated(line, linear, {0.4, 0.2, 9}), linear({0.3, 0.3, 2}), 1e-9);
  EXPECT_NEAR(interpolated({{1, 2, 3}}, linear, {9, 9, 9}), linear({1, 2, 3}), 1e-9);
  EXPECT_NEAR(interpolated({{0, 0, 0}, {1, 0, 0}}, linear, {0.25, 7, 1}), linear({0.25, 0, 0}), 1e-9);
}

TEST(ScatteredInterpolation, GoesOnConstantFarOutside) {
  std::vector<Vector3> points;
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j)
      for (int k = 0; k <= 10; ++k) points.emplace_back(0.1 * i, 0.1 * j, 0.1 * k);
  const ScatteredInterpolation interpolation(points);
  EXPECT_DOUBLE_EQ(interpolated(points, linear, {0.5, 0.5, 3}), linear({0.5, 0.5, 1}));
  EXPECT_NEAR(interpolation.outside({0.5, 0.5, 3}).distance, 2, 1e-9);
  EXPECT_EQ(interpolation.outside({0.53, 0.5, 0.98}).distance, 0);
  EXPECT_EQ(interpolation.outside({0.53, 0.5, 1.02}).distance, 0);
  EXPECT_NEAR(interpolated(points, linear, {0.53, 0.51, 1.02}), linear({0.53, 0.51, 1.02}), 1e-9);
}

}  // namespace
}  // namespace creepcontact::mechanics
