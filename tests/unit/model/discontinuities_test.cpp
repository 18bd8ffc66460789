/// Discontinuities and jumps of expressions in time.
#include "../../../src/model/discontinuities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

namespace creepcontact::model {
namespace {

Discontinuities discontinuities_of(const std::string& expression, double end) {
  const Function f = Function::expression(expression, {"x", "y", "z", "t"});
  return find_discontinuities([&](double t) { return f({.x = 0.2, .y = 3.1, .z = 0.9, .t = t}); }, {0, end});
}

void expect_times(const std::string& expression, const std::vector<double>& found, const std::vector<double>& expected,
                  double error) {
  EXPECT_EQ(found.size(), expected.size()) << expression << ": " << testing::PrintToString(found);
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
    EXPECT_NEAR(found[i], expected[i], error * expected[i]) << expression;
}

struct Expected {
  const char* expression;
  double end;
  std::vector<double> kinks, jumps;
};

TEST(Discontinuities, AreFoundToRounding) {
  const double pi = std::numbers::pi, third = 1.0 / 3;
  const std::vector<Expected> cases{
      {"100*min(t/10, 1)", 1e3, {10}, {}},
      {"100*min(t/10, 1)", 1e6, {10}, {}},
      {"min(t/1e-3, 1)", 1e6, {1e-3}, {}},
      {"min(max((t - 5e5)/10, 0), 1)", 1e6, {5e5, 5e5 + 10}, {}},
      {"x*abs(sin(t))", 10, {pi, 2 * pi, 3 * pi}, {}},
      {"abs(t - 1/3) + t^2", 2, {third}, {}},
      {"100*t^2 + abs(t - 0.7)", 1, {0.7}, {}},
      {"max(0, 1 - abs(t - 700)/10)", 1e3, {690, 700, 710}, {}},
      {"sqrt(max(t - 2, 0))", 10, {2}, {}},
      {"t < 20 ? 5 : t/4", 50, {20}, {}},
      {"z*max(exp(-t), 0.1)", 10, {std::log(10.0)}, {}},
      {"y > 2 ? min(t, 3) : 0", 10, {3}, {}},
      {"t < 10 ? 1 : 2", 40, {}, {10}},
      {"t <= 10 ? 1 : 2", 40, {}, {10}},
      {"rint(t)", 4, {}, {0.5, 1.5, 2.5, 3.5}},
      {"t < 10 ? t : sin(t)", 12, {}, {10}},
      {"mod(t, 1e5) < 7e4 ? min(mod(t, 1e5)/0.5, 1) : 0", 2e5, {0.5, 1e5, 100000.5}, {7e4, 1.7e5}},
      {"(t < 0.3 ? 0 : 1) + min(t/5, 1)", 10, {5}, {0.3}}};
  for (const Expected& expected : cases) {
    const Discontinuities found = discontinuities_of(expected.expression, expected.end);
    expect_times(expected.expression, found.kinks, expected.kinks, 1e-9);
    expect_times(expected.expression, found.jumps, expected.jumps, 1e-15);
    EXPECT_FALSE(found.too_many) << expected.expression;
  }
}

/// On both sides of a jump's time stand the values on both sides of the jump.
TEST(Discontinuities, AJumpIsKnownToTheLastBit) {
  for (const char* expression : {"t < 1/3 ? 1 : 2", "t <= 1/3 ? 1 : 2", "floor(3*t)", "floor(t/0.1)"}) {
    const Function f = Function::expression(expression, {"t"});
    const Discontinuities found = discontinuities_of(expression, 3);
    EXPECT_FALSE(found.jumps.empty()) << expression;
    for (const double t : found.jumps)
      EXPECT_NEAR(f({.t = std::nextafter(t, 9.0)}) - f({.t = std::nextafter(t, 0.0)}), 1, 1e-9) << expression << t;
  }
}

TEST(Discontinuities, SmoothFunctionsHaveNone) {
  for (const char* expression :
       {"sin(t)", "exp(-t)", "exp(-1000*t)", "sqrt(t)", "t^0.3", "1/(1+t)", "t^1.5", "t^3 - t", "ln(t)", "sin(200*t)",
        "sin(2000*t)", "1e5*sin(t/7)*exp(-t/20)", "tanh((t - 5)*1e4)", "1e6 + sin(t)", "cos(x*t)^2", "3*t + 1e4",
        "max(t - 2, 0)^2", "exp(-((t - 5)/0.01)^2)"})
    for (const double end : {10.0, 100.0}) {
      const Discontinuities found = discontinuities_of(expression, end);
      expect_times(expression, found.kinks, {}, 0);
      expect_times(expression, found.jumps, {}, 0);
      EXPECT_FALSE(found.too_many) << expression;
    }
  expect_times("1/(1+t)", discontinuities_of("1/(1+t)", 1e6).kinks, {}, 0);
  expect_times("sqrt(t)", discontinuities_of("sqrt(t)", 1e6).kinks, {}, 0);
}

TEST(Discontinuities, OfAHundredCycles) {
  const std::clock_t start = std::clock();
  const Discontinuities found = discontinuities_of("max(0, min(min(mod(t, 50), (25 - mod(t, 50))), 1))", 5000);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;  // of the processor
  EXPECT_TRUE(found.jumps.empty());
  ASSERT_EQ(found.kinks.size(), 399u);
  for (std::size_t i = 0; i < found.kinks.size(); ++i) {
    const std::size_t cycle = (i + 1) / 4;
    const double base = 50 * static_cast<double>(cycle);
    const double phase = std::vector<double>{0, 1, 24, 25}[(i + 1) % 4];
    EXPECT_NEAR(found.kinks[i], base + phase, 1e-9 * (base + phase));
  }
  RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
  EXPECT_LT(seconds, 0.5);
}

TEST(Discontinuities, OfAFastSawAreTooMany) {
  for (const char* expression : {"mod(t, 1e-2)", "abs(sin(1e4*t))"}) {
    const Discontinuities found = discontinuities_of(expression, 1000);
    EXPECT_TRUE(found.too_many) << expression;
    EXPECT_TRUE(found.kinks.empty() && found.jumps.empty());
  }
}

/// Where a root has no value it counts as 0; what comes later is found all the same.
TEST(Discontinuities, OfAFunctionThatIsNoNumberForATime) {
  const Discontinuities found = discontinuities_of("sqrt(t - 3) + (t > 7 ? 1 : 0) + abs(t - 8)", 10);
  EXPECT_EQ(found.jumps, (std::vector<double>{3, 7}));
  expect_times("a root", found.kinks, {8}, 1e-9);
}

TEST(Discontinuities, OfAnIntervalThatBeginsLater) {
  const Function f = Function::expression("(t > 730 && t < 730.5 ? 1 : 0) + abs(t - 731)", {"t"});
  const Discontinuities found = find_discontinuities([&](double t) { return f({.t = t}); }, {720, 732}, 509);
  EXPECT_EQ(found.jumps, (std::vector<double>{730, 730.5}));
  expect_times("an interval", found.kinks, {731}, 1e-9);
}

}  // namespace
}  // namespace creepcontact::model
