/// Times at which functions of time turn back, and bounds on steps where they vibrate.
#include "../../../src/model/extrema.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace creepcontact::model {
namespace {

Extrema extrema_of(const char* expression, double end) {
  const Function f = Function::expression(expression, {"t"});
  return find_extrema([&](double t) { return f({.t = t}); }, {0, end});
}

void expect_turns(const char* expression, double end, const std::vector<double>& expected, double error) {
  const Extrema found = extrema_of(expression, end);
  ASSERT_EQ(found.turns.size(), expected.size()) << expression;
  EXPECT_EQ(found.count, static_cast<double>(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found.turns[i].time, expected[i], error) << expression;
}

TEST(Extrema, RoundingOfAConstantIsNoVibration) {
  const Extrema found = extrema_of("300*(1 + 1e-15*sin(1e4*t))", 1000);
  EXPECT_TRUE(found.turns.empty());
  EXPECT_TRUE(found.limits.empty());
  EXPECT_EQ(found.count, 0);
}

TEST(Extrema, OfAnOscillation) {
  expect_turns("-0.02*cos(3.14159265358979*t/250)", 1000, {250, 500, 750}, 1e-3);
  expect_turns("sin(t)", 9.0, {1.5708, 4.7124, 7.854}, 1e-3);
}

TEST(Extrema, OfPulses) {
  expect_turns("100*max(0, 1 - abs(t - 700)/10)", 1000, {700}, 1e-3);
  expect_turns("exp(-((t - 700)/0.1)^2)", 1000, {700}, 1e-3);
  expect_turns("(t > 699.9 && t < 700.05) ? 1 : 0", 1000, {700}, 0.15);
}

TEST(Extrema, MonotonousFunctionsHaveNone) {
  expect_turns("min(t/10, 1)", 1000, {}, 0);
  expect_turns("exp(-t)", 1000, {}, 0);
  expect_turns("3 + 0*t", 1000, {}, 0);
}

/// Periods that divide the distances of samples, of any number.
TEST(Extrema, OfAVibrationBoundSteps) {
  for (const double n : {101., 777., 7777., 8192., 16381., 16384., 32000., 1e5, 131072., 1e6, 1e8}) {
    const Extrema found = extrema_of(fmt::format("100 + 50*sin(2*pi*t*{}/1000)", n).c_str(), 1000);
    ASSERT_EQ(found.turns.size(), 2U) << n;  // the extremes of the load, for the scale of the stress
    EXPECT_NEAR(found.count / (2 * n), 1, n < 6e4 ? 1e-4 : 0.3) << n;
    const StepLimits limits(found.limits);
    for (int i = 1; i < 50; ++i) {
      const double t = 1000 * (i + 0.37) / 50;
      EXPECT_LT((limits.latest_end(t) - t) * n / 1000, 0.13) << n << ' ' << t;
      EXPECT_GT((limits.latest_end(t) - t) * n / 1000, 0.02) << n << ' ' << t;
    }
  }
}

/// Bounds hold where the vibration is, and a step from before it ends there.
TEST(Extrema, OfAVibrationForATime) {
  const Extrema found = extrema_of("(t > 300 && t < 310) ? sin(100*t) : 0", 1000);
  EXPECT_EQ(found.turns.size(), 2U);
  EXPECT_NEAR(found.count, 318, 3);
  const StepLimits limits(found.limits);
  EXPECT_LT(limits.latest_end(305) - 305, 0.01);
  EXPECT_LT(limits.latest_end(10), 300.1);
  EXPECT_GT(limits.latest_end(320), 1000);
}

/// Jumps among turns that are too close to look for kinks.
TEST(Extrema, OfAVibrationThatJumps) {
  const Extrema found = extrema_of("sin(2*pi*5*t) + (t > 123.4567 ? 10 : 0)", 1000);
  EXPECT_EQ(found.jumps, std::vector<double>{123.4567});
}

TEST(Extrema, WhatIsNoNumberForATime) {
  const Extrema found = extrema_of("sqrt(t - 1)*cos(t)", 10.0);
  ASSERT_GE(found.turns.size(), 2U);
  EXPECT_NEAR(found.turns.back().time, 9.483, 0.01);
}

}  // namespace
}  // namespace creepcontact::model
