/// When a condition begins to hold: the instant, and in how many states.

#include "../../../src/run/condition_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace creepcontact::run::test {
namespace {

constexpr double resolution = 1e-10;

struct Found {
  double time;
  int states;
};

/// The first time in (from, to] at which f falls below zero, f being the value of the condition.
Found fall(double from, double to, const std::function<double(double)>& f, bool gives_values = true) {
  int states = 0;
  const auto state = [&](double t) -> ConditionState {
    return {f(t) < 0, gives_values ? std::vector<double>{f(t)} : std::vector<double>{}};
  };
  const double time = first_time(
      from, to, resolution, state(to),
      [&](double t) {
        ++states;
        return state(t);
      },
      [](double, std::span<const double> values) { return values[0] < 0; });
  return {time, states};
}

TEST(ConditionSearch, GuessesTheInstantOfSmoothValues) {
  const double from = 2, to = 5;
  for (const double root : {2 + 1e-7, 2.3, 3.1, 3.5, 4.2, 5 - 1e-7}) {
    const auto relaxation = [&](double t) { return std::pow(1 + t, -1.0 / 7) - std::pow(1 + root, -1.0 / 7); };
    const Found found = fall(from, to, relaxation);
    EXPECT_NEAR(found.time, root, 1.1 * resolution * (to - from));
    EXPECT_LT(relaxation(found.time), 0);
    EXPECT_LE(found.states, 8);
  }
}

TEST(ConditionSearch, FindsTheInstantWithoutValues) {
  const Found found = fall(
      0, 1, [](double t) { return 0.3 - t; }, false);
  EXPECT_NEAR(found.time, 0.3, resolution);
  EXPECT_EQ(found.states, 34);  // log2(1e10)
}

TEST(ConditionSearch, IsNotMisledByKinksAndJumps) {
  const auto kink = [](double t) { return t < 0.7 ? 1e-3 * (0.71 - t) : 0.01e-3 - 50 * (t - 0.7); };
  const auto jump = [](double t) { return t < 0.123 ? 1 : -1e-9 * t; };
  const auto undefined = [](double t) { return t < 0.4 ? std::numeric_limits<double>::quiet_NaN() : -1; };
  for (const auto& [f, instant] : std::vector<std::pair<std::function<double(double)>, double>>{
           {kink, 0.7 + 2e-7}, {jump, 0.123}, {undefined, 0.4}}) {
    const Found found = fall(0, 1, f);
    EXPECT_NEAR(found.time, instant, resolution);
    EXPECT_LE(found.states, 2 * 34);
  }
}

TEST(ConditionSearch, EndsWhereNumbersDo) {
  const double from = 1e5, to = std::nextafter(1e5, 2e5);
  EXPECT_EQ(fall(from, to, [&](double t) { return t < to ? 1 : -1; }).time, to);
  EXPECT_EQ(fall(1, 1, [](double) { return -1; }).time, 1);
}

}  // namespace
}  // namespace creepcontact::run::test
