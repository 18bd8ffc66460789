/// What is found in functions that repeat, with and without a period that is known.
#include "../../../src/model/course_events.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace creepcontact::model {
namespace {

CourseEvents events_of(const std::string& expression, double end, std::optional<double> cycle = {}) {
  const Function f = Function::expression(expression, {"t"});
  return find_events([&](double t) { return f({.t = t}); }, end, cycle, {});
}

bool has(const std::vector<double>& times, double t, double error) {
  return std::ranges::any_of(times, [&](double found) { return std::abs(found - t) <= error; });
}

TEST(CourseEvents, OneCycleOfAThousandThatDiffers) {
  for (const double from : {2013., 15., 9991., 0.5, 12.3}) {
    const CourseEvents found = events_of(fmt::format("100*(t > {} && t < {} ? 6.7 : 1)", from, from + 5), 10000, 10);
    EXPECT_EQ(found.jumps, (std::vector<double>{from, from + 5})) << from;
  }
  const CourseEvents on_pulses = events_of("min(1, mod(t, 10)) + (t > 5432.1 && t < 5432.25 ? 1 : 0)", 10000, 10);
  EXPECT_TRUE(has(on_pulses.jumps, 5432.1, 1e-9) && has(on_pulses.jumps, 5432.25, 1e-9));
  EXPECT_TRUE(has(on_pulses.kinks, 5431, 1e-6) && has(on_pulses.kinks, 9991, 1e-6));
  EXPECT_FALSE(on_pulses.too_many);
}

/// Pulses of a hundredth of a cycle and longer, anywhere, in several cycles.
TEST(CourseEvents, PulsesInSomeCycles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 20; ++run) {
    const double n = std::floor(10 * std::pow(10, 2 * uniform(random))), from = n * uniform(random);
    const double until = from + 0.01 + 0.2 * uniform(random);
    if (until > n) continue;
    const CourseEvents found =
        events_of(fmt::format("100 + 20*mod(t, 1) + (t > {} && t < {} ? 5 : 0)", from, until), n, 1);
    EXPECT_TRUE(has(found.jumps, from, 1e-9)) << from << ' ' << n;
    EXPECT_TRUE(has(found.jumps, until, 1e-9)) << from << ' ' << until << ' ' << n;
  }
}

TEST(CourseEvents, APeriodThatNobodyNames) {
  for (const char* expression : {"mod(t, 0.0731)", "mod(t, 0.1) < 0.03 ? 1 : 2", "floor(t/0.05)*0 + mod(t, 0.05)"}) {
    const CourseEvents found = events_of(expression, 1000);
    EXPECT_FALSE(found.too_many) << expression;
    EXPECT_GT(found.jumps.size(), 9000U) << expression;
    const Function f = Function::expression(expression, {"t"});
    for (std::size_t i = 0; i < found.jumps.size(); i += 97) {  // on both sides of a jump stand its values
      const double t = found.jumps[i];
      EXPECT_GT(std::abs(f({.t = std::nextafter(t, 2e3)}) - f({.t = std::nextafter(t, 0.0)})), 0.04) << t;
    }
  }
  const CourseEvents kinks = events_of("abs(sin(2*pi*t*9000/1000))", 1000);
  EXPECT_FALSE(kinks.too_many);
  ASSERT_EQ(kinks.kinks.size(), 17999U);
  EXPECT_TRUE(has(kinks.kinks, 1000 * 12345 / 18000.0, 1e-8));
}

TEST(CourseEvents, AreTooMany) {
  for (const char* expression : {"mod(t, 1e-3)", "abs(sin(1e4*t))", "mod(t^2, 0.37)"})
    EXPECT_TRUE(events_of(expression, 1000).too_many) << expression;
}

/// Of a vibration for a time, its begin and end too.
TEST(CourseEvents, AVibrationForATime) {
  const CourseEvents found = events_of("(t > 300.123 && t < 700.77) ? 100 + 50*sin(2*pi*3*t + 1) : 100", 1000);
  EXPECT_FALSE(found.too_many);
  EXPECT_TRUE(found.vibrates);
  EXPECT_TRUE(has(found.jumps, 300.123, 1e-9) && has(found.jumps, 700.77, 1e-9));
}

/// The shortest pulses that are found for certain (docs/integrators.md): of the run, of one cycle.
TEST(CourseEvents, TheShortestPulse) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 30; ++run) {
    const double from = 0.1 + 0.89 * uniform(random), until = from + 1.0 / 16000;
    const CourseEvents found = events_of(fmt::format("t > {} && t < {} ? 1 : 0", from, until), 1);
    EXPECT_EQ(found.jumps.size(), 2U) << from;
  }
  for (int run = 0; run < 10; ++run) {
    const double from = 1.2 + 998 * uniform(random), until = from + 1.0 / 390;
    const CourseEvents found = events_of(fmt::format("t > {} && t < {} ? 1 : 0", from, until), 1000, 1);
    EXPECT_EQ(found.jumps.size(), 2U) << from;
  }
}

}  // namespace
}  // namespace creepcontact::model
