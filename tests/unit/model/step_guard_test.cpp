#include "creepcontact/model/step_guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

namespace creepcontact::model {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr StepGuard::Segment unbounded{-infinity, infinity};

StepGuard guard_of(std::function<double(double)> course, double end = 1000, double tolerance = 1e-4) {
  return StepGuard({{.key = "loads[0].pressure", .at_places = {std::move(course)}}}, end, tolerance);
}

TEST(StepGuard, WhatAStepFollowsPasses) {
  const std::vector<std::pair<const char*, std::function<double(double)>>> smooth{
      {"constant", [](double) { return 3.0; }},
      {"ramp", [](double t) { return 2 * t - 700; }},
      {"parabola", [](double t) { return t * (1000 - t); }},
      {"relaxation", [](double t) { return 50 + 50 * std::exp(-t / 400); }},
      {"sixth of a period", [](double t) { return std::sin(2 * std::numbers::pi * t / 1800); }}};
  for (const auto& [name, course] : smooth) EXPECT_FALSE(guard_of(course).examine(0, 100, 400, unbounded)) << name;
}

TEST(StepGuard, PowersOfTimePassOverDecades) {
  for (const double exponent : {-0.6, 1.0 / 3, 2.5}) {
    const StepGuard guard = guard_of([=](double t) { return std::pow(t, exponent); });
    EXPECT_FALSE(guard.examine(0, 1, 6, unbounded)) << exponent;
  }
}

TEST(StepGuard, JumpsAreFoundToTheBit) {
  const StepGuard guard = guard_of([](double t) { return t >= 412.75 ? 7.0 : 5.0; });
  const auto found = guard.examine(0, 300, 800, unbounded);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_jump);
  EXPECT_EQ(found->time, 412.75);
  EXPECT_FALSE(guard.examine(0, 412.75, 900, unbounded));
}

TEST(StepGuard, JumpsAtTheEndsOfASegmentCountFromWithin) {
  const StepGuard guard = guard_of([](double t) { return t >= 200 && t < 300 ? 1.0 : 0.0; });
  EXPECT_FALSE(guard.examine(0, 200, 300, {std::nextafter(200.0, 300.0), std::nextafter(300.0, 0.0)}));
}

TEST(StepGuard, RandomPulsesOfATenthOfTheStep) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  int n_found = 0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i) {
    const double begin = 100 + 700 * number(random), width = 100;
    const StepGuard guard =
        guard_of([=](double t) { return t >= begin && t < begin + width ? 11.0 : 10.0; }, 1000, 1e-3);
    const double from = 50 * number(random);
    const auto found = guard.examine(0, from, from + 1000, unbounded);
    if (!found) continue;
    ++n_found;
    EXPECT_TRUE(found->is_jump);
    EXPECT_NEAR(found->time, begin, 1e-9) << "pulse from " << begin;
  }
  EXPECT_EQ(n_found, n);
}

TEST(StepGuard, ShortPulsesAreFoundAsOftenAsThePagesSay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  int n_found = 0;
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double begin = 10 + 980 * number(random);
    const StepGuard guard = guard_of([=](double t) { return t >= begin && t < begin + 10 ? 2.0 : 1.0; }, 1e6, 1e-3);
    if (guard.examine(0, number(random), 1000, unbounded)) ++n_found;
  }
  EXPECT_NEAR(static_cast<double>(n_found) / n, 0.15, 0.03);  // a pulse of a hundredth of the step
}

TEST(StepGuard, SmoothPulsesShortenTheStep) {
  const StepGuard guard = guard_of([](double t) { return 1 + 5 * std::exp(-std::pow((t - 500) / 30, 2)); });
  const auto onset = guard.examine(0, 300, 800, unbounded);
  ASSERT_TRUE(onset);
  EXPECT_FALSE(onset->is_jump);
  EXPECT_GT(onset->time, 350);
  EXPECT_LT(onset->time, 450);
  const auto inside = guard.examine(0, 480, 800, unbounded);
  ASSERT_TRUE(inside);
  EXPECT_GT(inside->time, 485);
  EXPECT_LT(inside->time, 540);
}

TEST(StepGuard, OscillationsAreFollowedByAFewStepsPerPeriod) {
  const StepGuard guard = guard_of([](double t) { return 100 + 20 * std::sin(2 * std::numbers::pi * t); });
  double t = 0;
  int n_steps = 0;
  for (; t < 10; ++n_steps) {
    const auto found = guard.examine(0, t, t + 57.3, unbounded);
    ASSERT_TRUE(found);
    ASSERT_GT(found->time, t);
    t = found->time;
  }
  EXPECT_LT(n_steps, 60);
  EXPECT_GT(n_steps, 15);
}

TEST(StepGuard, ARootAtTheStartDoesNotStopTheRun) {
  const StepGuard guard = guard_of([](double t) { return std::sqrt(t); });
  double t = 0;
  int n_steps = 0;
  for (; t < 1000 && n_steps < 1000; ++n_steps) {
    const auto found = guard.examine(0, t, 1000, unbounded);
    t = found ? found->time : 1000;
  }
  EXPECT_LT(n_steps, 60);
}

// A breakpoint may be a little later than the kink that it stands for.
TEST(StepGuard, AKinkRightBeforeTheEndOfASegmentIsNoJump) {
  constexpr double begin = 0.0526680142793, kink = 0.12246378256459;
  for (const double late : {1e-14, 1e-13, 1e-12, 7e-12, 1e-11, 1e-10}) {
    const auto course = [=](double t) { return 1e-8 + std::clamp(1e-2 * (t - kink), 0.0, 1.4e-5); };
    const StepGuard guard = guard_of(course, 0.5, 1e-6);
    const double end = kink + late;
    const auto found = guard.examine(0, begin, end, {begin, end * (1 - 4e-16)});
    EXPECT_FALSE(found && found->is_jump) << late;
  }
}

TEST(StepGuard, PlacesChangeFromStepToStep) {
  std::vector<std::function<double(double)>> places;
  for (int i = 0; i < 100; ++i)  // it acts at one place in twenty
    places.emplace_back([=](double t) { return i < 5 && t >= 0.5 ? 1.0 : 0.0; });
  const StepGuard guard({{.key = "loads[0].pressure", .at_places = places}}, 1000, 1e-3);
  int n_found = 0;
  for (int step = 0; step < 200; ++step)
    if (guard.examine(0, 1e-3 * step, 1, unbounded)) ++n_found;
  EXPECT_NEAR(n_found, 30, 15);  // three places per step
}

TEST(StepGuard, APlaceWithoutAValueIsPassedOver) {
  const auto course_at = [](double x) { return [x](double t) { return std::sqrt(x) * (t >= 0.5 ? 2 : 1); }; };
  const StepGuard guard({{.key = "loads[0].traction[0]", .at_places = {course_at(-1), course_at(1)}}}, 1, 1e-3);
  const auto found = guard.examine(0, 0.1, 0.9, unbounded);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->time, 0.5);
}

TEST(StepGuard, AnswersDependOnTheArgumentsAlone) {
  const auto course = [](double t) { return std::sin(t * t); };
  const StepGuard one = guard_of(course), other = guard_of(course);
  (void)one.examine(0, 3, 8, unbounded);
  const auto a = one.examine(0, 10, 20, unbounded), b = other.examine(0, 10, 20, unbounded);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->time, b->time);
  EXPECT_EQ(a->deviation, b->deviation);
}

}  // namespace
}  // namespace creepcontact::model
