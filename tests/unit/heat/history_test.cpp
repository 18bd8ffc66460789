/// What repeats is integrated until it does, and no further.
#include "creepcontact/heat/history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "creepcontact/mechanics/temperature_field.hpp"
#include "support/mechanics/meshes.hpp"

namespace creepcontact::heat {
namespace heat_history_tests {
namespace {

using namespace test;

constexpr double range = 100, tolerance = 1e-4 * range, end = 400;

mechanics::TemperatureField field_of(const History& history) {
  mechanics::ScatteredTemperatures given;
  given.points = {Vector3::Zero()};
  given.times = history.times;
  const auto first = [](const std::vector<std::vector<double>>& all) {
    std::vector<std::vector<double>> result;
    for (const std::vector<double>& values : all) result.push_back({values.front()});
    return result;
  };
  given.values = first(history.values);
  given.rates_before = first(history.rates_before);
  given.rates_after = first(history.rates_after);
  given.kinks = history.kinks;
  given.last_period = history.period;
  return mechanics::TemperatureField(std::move(given));
}

/// A slab with a time constant of ten, on one side a fluid. @param repeats  known
History slab(const Function& fluid, std::vector<double> kinks, std::optional<Repeats> repeats,
             double allowed = tolerance) {
  const mesh::Mesh mesh = box_mesh(CellType::hex8, {1, 1, 4}, {1, 1, 1});
  Definition all;
  all.bodies = {{"slab", &mesh, {40.0}, {}, 1.0, 1.0}};
  all.flows = {{SurfaceFlow::Kind::film, 0, mesh::boundary_faces(mesh, "z1"), 0.1, fluid}};
  Conduction problem(std::move(all));
  return integrate(problem, problem.unknowns(0.0), {end, std::move(kinks), allowed, {}, repeats});
}

double largest_error(const History& history, const History& exact) {
  const mechanics::TemperatureField field = field_of(history), expected = field_of(exact);
  double largest = 0;
  for (int k = 0; k <= 4000; ++k) {
    const Arguments at{.t = end * k / 4000};
    largest = std::max(largest, std::abs(field(at) - expected(at)));
  }
  return largest;
}

/// It adds less than the tolerance to the error of the integration, most of it where the integration starts again.
void expect_repeated(const Function& fluid, const std::vector<double>& kinks, const Repeats& repeats) {
  const History exact = slab(fluid, kinks, {}, 0.01 * tolerance), whole = slab(fluid, kinks, {}),
                repeated = slab(fluid, kinks, repeats);
  EXPECT_FALSE(whole.period);
  ASSERT_TRUE(repeated.period);
  EXPECT_EQ(*repeated.period, repeats.period);
  EXPECT_LT(repeated.times.back(), 0.4 * end);
  EXPECT_LT(repeated.times.size(), 0.5 * static_cast<double>(whole.times.size()));
  EXPECT_EQ(whole.kinks, repeated.kinks);
  EXPECT_EQ(field_of(whole).breakpoints(end), field_of(repeated).breakpoints(end));
  EXPECT_NE(field_of(whole).text(), field_of(repeated).text());
  EXPECT_LT(largest_error(repeated, exact), largest_error(whole, exact) + tolerance);
}

TEST(HeatHistory, RepeatsWhereTheFluidHasKinks) {
  const Function fluid = Function::table("t", {0, 2, 5, 6}, {0, range, range, 0}, 8);
  expect_repeated(fluid, fluid.breakpoints(end), {0, 8});
}

TEST(HeatHistory, RepeatsWhereTheFluidIsSmooth) {
  const Function fluid = Function::expression("50 + 50*sin(2*_pi*t/7)", {"t"});
  expect_repeated(fluid, {}, {0, 7});
  const auto exact = [](double t) {  // of one temperature; that of the slab is nearly one
    const double w = 2 * std::numbers::pi / 7 * 10;
    return 50 +
           50 * (std::sin(2 * std::numbers::pi * t / 7) - w * std::cos(2 * std::numbers::pi * t / 7)) / (1 + w * w);
  };
  const mechanics::TemperatureField field = field_of(slab(fluid, {}, Repeats{0, 7}));
  for (const double t : {390.0, 393.0, 396.0, 399.0}) EXPECT_NEAR(field({.t = t}), exact(t), 0.1);
}

TEST(HeatHistory, RepeatsAfterTheLastPeriodThatDiffers) {
  const Function fluid = Function::expression("(t < 24 ? 3 : 1)*50*max(sin(2*_pi*t/8), 0)", {"t"});
  std::vector<double> kinks{24};
  for (double t = 4; t < end; t += 4)
    if (t != 24) kinks.push_back(t);
  std::ranges::sort(kinks);
  expect_repeated(fluid, kinks, {24, 8});
  EXPECT_GT(slab(fluid, kinks, Repeats{24, 8}).times.back(), 40);
}

TEST(HeatHistory, OfGivenTemperaturesThatJumpIsIntegratedToTheEnd) {
  const mesh::Mesh mesh = box_mesh(CellType::hex8, {1, 1, 4}, {1, 1, 1});
  const Function given = Function::table("t", {0, 4, 4, 8}, {0, 0, range, range}, 8);
  Definition all;
  all.bodies = {{"slab", &mesh, {40.0}, {}, 1.0, 1.0}};
  all.given = {{0, mesh::group_nodes(mesh, "z1"), given}};
  Conduction problem(std::move(all));
  const History history =
      integrate(problem, problem.unknowns(0.0), {80, given.breakpoints(79), tolerance, {}, Repeats{0, 8}});
  EXPECT_FALSE(history.period);
  EXPECT_EQ(history.times.back(), 80);
}

}  // namespace
}  // namespace heat_history_tests
}  // namespace creepcontact::heat
