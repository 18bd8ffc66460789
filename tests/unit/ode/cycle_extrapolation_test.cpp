#include "creepcontact/ode/cycle_extrapolation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace creepcontact::ode {
namespace {

using State = std::vector<double>;
/// The state after a cycle that begins with y.
using Map = std::function<State(const State& y)>;

struct Result {
  State y;
  int computed = 0, rejected = 0;
  std::int64_t longest = 0;
};

/// n cycles, with jumps.
Result cycles(const Map& map, State y, std::int64_t n, double tolerance,
              const CycleExtrapolation::Damping& damping = {}) {
  const State scales(y.size(), 1.0);
  CycleExtrapolation extrapolation(serial_team(), tolerance);
  Result result;
  for (std::int64_t done = 0; done < n;) {
    const std::int64_t jump = std::min(extrapolation.proposal(), n - done - 1);
    if (jump > 0) {
      extrapolation.jump(jump, y);
      y = map(y);
      ++result.computed;
      if (extrapolation.check(scales, damping, y)) {
        done += jump + 1;
        result.longest = std::max(result.longest, jump);
      } else {
        ++result.rejected;
      }
      continue;
    }
    const State before = y;
    y = map(y);
    ++result.computed;
    extrapolation.add_cycle(done++, before, y);
  }
  result.y = y;
  return result;
}

State every_cycle(const Map& map, State y, int n) {
  for (int k = 0; k < n; ++k) y = map(y);
  return y;
}

/// Stress that relaxes by Norton's law, at constant strain; the state is the creep strain over the elastic one.
State relaxed(const State& y, double exponent, double rate) {
  State after = y;
  for (double& strain : after)
    strain = 1 - std::pow(std::pow(1 - strain, 1 - exponent) + (exponent - 1) * rate, 1 / (1 - exponent));
  return after;
}

TEST(CycleExtrapolation, AConstantChangeIsExact) {
  const Result found = cycles([](const State& y) { return State{y[0] + 0.25, y[1] - 1}; }, {0, 3}, 1000, 1e-3);
  EXPECT_NEAR(found.y[0], 250, 1e-9);
  EXPECT_NEAR(found.y[1], -997, 1e-9);
  EXPECT_LE(found.computed, 15);
}

TEST(CycleExtrapolation, RelaxationIsWithinTheTolerance) {
  for (const double exponent : {3.0, 7.0, 12.0})
    for (const double tolerance : {1e-3, 1e-4}) {
      const Map map = [=](const State& y) { return relaxed(y, exponent, 0.2); };
      const Result found = cycles(map, {0, 0.2, 0.5}, 1000, tolerance);
      const State exact = every_cycle(map, {0, 0.2, 0.5}, 1000);
      for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(found.y[i], exact[i], 2 * tolerance);
      EXPECT_LE(found.computed, tolerance < 1e-3 ? 120 : 60) << exponent;
    }
}

TEST(CycleExtrapolation, DampingKeepsFastModesFromBoundingTheJumps) {
  for (const double share : {0.9, 0.5, 0.1}) {
    // The first entry follows the second one, which is slow: this share of their difference is left by each cycle.
    const Map map = [=](const State& y) { return State{share * y[0] + (1 - share) * y[1] + 1e-3, y[1] + 1e-3}; };
    const State exact = every_cycle(map, {1, 0}, 1000);
    // The local Jacobian is twice the true one: an estimate will do.
    const auto damping = [=](double weight, std::span<const double> change, std::span<double> damped) {
      damped[0] = change[0] / (1 - 2 * weight * std::log(share));
      damped[1] = change[1];
    };
    const Result plain = cycles(map, {1, 0}, 1000, 1e-3), damped = cycles(map, {1, 0}, 1000, 1e-3, damping);
    for (const Result* result : {&plain, &damped})
      for (int i : {0, 1}) EXPECT_NEAR(result->y[i], exact[i], 2e-3) << share;
    EXPECT_LE(damped.computed, 200) << share;
    EXPECT_LT(damped.computed, plain.computed) << share;
  }
}

TEST(CycleExtrapolation, AnErrorThatIsTooLargeTakesTheStateBack) {
  CycleExtrapolation extrapolation(serial_team(), 1e-3);
  State y{0};
  for (std::int64_t k = 0; k < 3; ++k) {
    const State before = y;
    y[0] += 1;
    extrapolation.add_cycle(k, before, y);
  }
  ASSERT_EQ(extrapolation.proposal(), 1);
  extrapolation.jump(1, y);
  EXPECT_TRUE(extrapolation.is_checking());
  EXPECT_NEAR(y[0], 4, 1e-12);
  y[0] += 2;  // another change
  EXPECT_FALSE(extrapolation.check(State{1}, {}, y));
  EXPECT_EQ(y[0], 3);
  EXPECT_GT(extrapolation.error(), 1);
  EXPECT_FALSE(extrapolation.is_checking());
  EXPECT_EQ(extrapolation.proposal(), 0) << "the next cycle is computed";
  extrapolation.add_cycle(3, {y}, State{4});
  EXPECT_EQ(extrapolation.proposal(), 1);
}

TEST(CycleExtrapolation, ANumberThatIsNoneIsRejected) {
  CycleExtrapolation extrapolation(serial_team(), 1e-3);
  for (std::int64_t k = 0; k < 3; ++k)
    extrapolation.add_cycle(k, State{static_cast<double>(k)}, State{static_cast<double>(k + 1)});
  State y{3};
  extrapolation.jump(1, y);
  y[0] = std::nan("");
  EXPECT_FALSE(extrapolation.check(State{1}, {}, y));
  EXPECT_EQ(y[0], 3);
}

TEST(CycleExtrapolation, OtherLoadsBeginAnew) {
  CycleExtrapolation extrapolation(serial_team(), 1e-3);
  for (std::int64_t k = 0; k < 3; ++k)
    extrapolation.add_cycle(k, State{static_cast<double>(k)}, State{static_cast<double>(k + 1)});
  EXPECT_GT(extrapolation.proposal(), 0);
  extrapolation.begin(3);
  EXPECT_EQ(extrapolation.proposal(), 0);
  extrapolation.add_cycle(3, State{0}, State{2});
  extrapolation.add_cycle(4, State{2}, State{4});
  EXPECT_EQ(extrapolation.proposal(), 0);
  extrapolation.add_cycle(5, State{4}, State{6});
  ASSERT_EQ(extrapolation.proposal(), 1);
  State y{6};
  extrapolation.jump(1, y);
  EXPECT_NEAR(y[0], 8, 1e-12);
}

TEST(CycleExtrapolation, ARestoredOneGoesOnAlike) {
  const Map map = [](const State& y) { return relaxed(y, 5, 0.1); };
  CycleExtrapolation first(serial_team(), 1e-3);
  State y{0, 0.3};
  std::int64_t k = 0;
  for (; k < 3; ++k) {
    const State before = y;
    y = map(y);
    first.add_cycle(k, before, y);
  }
  CycleExtrapolation::Memory numbers, states;
  first.save(numbers, states);
  CycleExtrapolation second(serial_team(), 1e-3);
  second.restore(numbers, states);
  State other = y;
  for (int jump = 0; jump < 5; ++jump) {
    const std::int64_t n = first.proposal();
    ASSERT_EQ(second.proposal(), n);
    if (n == 0) break;
    first.jump(n, y);
    second.jump(n, other);
    y = map(y);
    other = map(other);
    ASSERT_EQ(first.check(State{1, 1}, {}, y), second.check(State{1, 1}, {}, other));
    EXPECT_EQ(y, other);
  }
}

}  // namespace
}  // namespace creepcontact::ode
