/// The Runge-Kutta-Chebyshev method: its coefficients, and what stabilisation buys.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../../src/ode/chebyshev_stages.hpp"
#include "creepcontact/base/error.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace {

/// One step of length 1 of y' = z y from 1.
double stability_polynomial(const std::vector<ChebyshevStage>& stages, double z) {
  double before = 1;
  double y = 1 + stages[0].mu_rate * z;
  for (std::size_t j = 1; j < stages.size(); ++j) {
    const ChebyshevStage& a = stages[j];
    const double next = (1 - a.mu - a.nu) + a.mu * y + a.nu * before + a.mu_rate * z * y + a.gamma_rate * z;
    before = std::exchange(y, next);
  }
  return y;
}

TEST(ChebyshevStages, StabilityPolynomialIsBoundedByOne) {
  for (int s : {2, 3, 4, 5, 10, 37, 100, 200, 220}) {
    const auto stages = chebyshev_stages(s);
    ASSERT_EQ(stages.size(), static_cast<std::size_t>(s));
    const double bound = chebyshev_stability_bound(s);
    constexpr int samples = 20000;
    for (int k = 0; k <= samples; ++k) {
      const double z = -bound * k / samples;
      ASSERT_LE(std::abs(stability_polynomial(stages, z)), 1 + 1e-11) << "s = " << s << ", z = " << z;
    }
    EXPECT_LT(std::abs(stability_polynomial(stages, -0.5 * bound)), 0.97) << "damped inside, s = " << s;
    if (s % 2 == 1) continue;  // falls from 1/3 there, through zero
    EXPECT_GT(std::abs(stability_polynomial(stages, -1.05 * bound)), 1) << "the bound is sharp, s = " << s;
  }
}

TEST(ChebyshevStages, AreOfSecondOrder) {
  for (int s : {2, 5, 50, 200}) {
    const auto stages = chebyshev_stages(s);
    for (double z : {-1e-2, -1e-3}) {
      const double third = (stability_polynomial(stages, z) - (1 + z + z * z / 2)) / (z * z * z);
      EXPECT_GT(third, -1e-6) << s;  // 0 with two stages
      EXPECT_LT(third, 1.0 / 6) << s;
    }
    EXPECT_DOUBLE_EQ(stages.back().c, 1);
    for (std::size_t j = 1; j < stages.size(); ++j) EXPECT_GT(stages[j].c, stages[j - 1].c) << s;
  }
}

TEST(ChebyshevStages, TheLeastStableNumberIsTaken) {
  EXPECT_EQ(chebyshev_stage_count(0), 2);
  for (int s : {2, 3, 10, 199}) {
    EXPECT_EQ(chebyshev_stage_count(chebyshev_stability_bound(s) * (1 - 1e-12)), s);
    EXPECT_EQ(chebyshev_stage_count(chebyshev_stability_bound(s) * (1 + 1e-9)), s + 1);
  }
}

/// State at `end` after equal steps: every step is proposed anew, under a tolerance that accepts it.
double after_equal_steps(TestSystem& system, Values y, double end, int steps) {
  auto integrator = make_integrator("rkc2", system, {.tolerance = 1e3});
  for (int k = 0; k < steps; ++k) {
    const double t = end * k / steps;
    const double next = end * (k + 1) / steps;
    integrator->initialize(t, y, next - t);
    EXPECT_EQ(integrator->step(next).time, next);
    y.assign(integrator->state().begin(), integrator->state().end());
  }
  return y.back();
}

TEST(Rkc2, ObservedOrderOfConvergence) {
  const auto error = [](int steps) {
    RelaxingBar bar;
    return std::abs(RelaxingBar::stress(after_equal_steps(bar, {0}, 1, steps)) - RelaxingBar::exact_stress(1));
  };
  EXPECT_NEAR(std::log2(error(256) / error(512)), 2, 0.1);
  EXPECT_NEAR(std::log2(error(512) / error(1024)), 2, 0.05);
}

TEST(Rkc2, OrderHoldsWithManyStages) {
  const auto error = [](int steps) {
    LinearSystem system({-2e4, -1.0}, true);
    return std::abs(after_equal_steps(system, {1, 3}, 2, steps) - system.exact(1, 2, 3));
  };
  EXPECT_NEAR(std::log2(error(10) / error(20)), 2, 0.15);
  EXPECT_NEAR(std::log2(error(20) / error(40)), 2, 0.1);
}

TEST(Rkc2, InterpolatesToTheOrderOfTheMethod) {
  const auto error = [](double h) {
    LinearSystem system({-1.0});
    auto integrator = make_integrator("rkc2", system, {.tolerance = 1e3});
    integrator->initialize(0, Values{1}, h);
    integrator->step(h);
    Values y(1);
    double worst = 0;
    for (double theta : {0.25, 0.5, 0.75}) {
      integrator->interpolate(theta * h, y);
      worst = std::max(worst, std::abs(y[0] - std::exp(-theta * h)));
    }
    return worst;
  };
  EXPECT_NEAR(std::log2(error(0.1) / error(0.05)), 3, 0.15) << "the local error of the step itself";
}

TEST(Rkc2, IsStableFarBeyondTheCormeauStep) {
  // The step that accuracy allows is about 0.1; its stages grow with the square root of the stiffness.
  for (const auto& [stiffness, gain] : {std::pair{1e3, 2.5}, {1e4, 8.0}, {1e5, 25.0}}) {
    LinearSystem system({-1, -0.1 * stiffness, -stiffness}, true);
    auto integrator = make_integrator("rkc2", system, {.tolerance = 1e-3});
    const auto y = integrate(*integrator, 0, {2, 1, 0}, {10});
    EXPECT_NEAR(y[0][0], system.exact(0, 10, 2), 2e-3);
    EXPECT_NEAR(y[0][2], std::cos(10), 2e-3);
    const std::int64_t explicit_euler = std::llround(10 * stiffness / 2);
    EXPECT_LT(gain * static_cast<double>(system.counters().rate_evaluations), static_cast<double>(explicit_euler));
    EXPECT_EQ(system.counters().jacobian_products, 0);
    RecordProperty("rates_" + std::to_string(explicit_euler), static_cast<int>(system.counters().rate_evaluations));
  }
}

TEST(Rkc2, CostsNoMoreThanImplicitMethodsWhereStiffnessIsModerate) {
  // Over one relaxation time of the slowest of the graded bars.
  for (double grading : {1e2, 1e4}) {
    const auto cost = [&](const std::string& name) {
      ParallelBars bars(50, grading);
      IntegratorOptions options{.tolerance = 1e-3, .end_time = 1 / (ParallelBars::E * 1e-14 * 1e8)};
      auto integrator = make_integrator(name, bars, options);
      integrate(*integrator, 0, Values(50), {options.end_time});
      return bars.counters().rate_evaluations + bars.counters().jacobian_products;
    };
    EXPECT_LT(static_cast<double>(cost("rkc2")), 1.1 * static_cast<double>(cost("cvode_bdf"))) << grading;
    EXPECT_LT(grading == 1e2 ? 2 * cost("rkc2") : 5 * cost("rkc2"), cost("arkode_erk")) << grading;
  }
}

TEST(Rkc2, NeverTakesMoreStagesThanItsMaximum) {
  constexpr int most = 220;  // 200, and a tenth for the last step to a limit
  LinearSystem system({-1e-3, -1e6});
  auto integrator = make_integrator("rkc2", system, {.tolerance = 1e-2});
  integrator->initialize(0, Values{1, 0}, 1.0);
  double longest = 0;
  for (int k = 0; k < 20; ++k) {
    const std::int64_t before = system.counters().rate_evaluations;
    longest = std::max(longest, integrator->step(1e6).step);
    EXPECT_LE(system.counters().rate_evaluations - before, most);
  }
  EXPECT_EQ(integrator->counters().rejected_steps, 0);
  EXPECT_GT(longest, 1e4 * 2e-6) << "ten thousand stable steps of explicit Euler in one";
}

/// A bar drawn out at a constant rate: its stress, and with it the stiffness, grows from nothing to the steady state.
class DrawnBar : public TestSystem {
 public:
  static constexpr double E = 2e5, A = 3.125e-14, n = 5, draw = 1e-4;
  DrawnBar() : TestSystem(1, 200 / E) {}
  static double stress(double t, double y) { return E * (draw * t - y); }

 protected:
  void f(double t, std::span<const double> y, std::span<double> rate) const override {
    const double s = stress(t, y[0]);
    rate[0] = A * std::pow(std::abs(s), n - 1) * s;
  }
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    local(t, y, product);
    product[0] *= v[0];
  }
  void local(double t, std::span<const double> y, std::span<double> diagonal) const override {
    diagonal[0] = -E * n * A * std::pow(std::abs(stress(t, y[0])), n - 1);
  }
};

TEST(Rkc2, FollowsAGrowingSpectralRadius) {
  for (double tolerance : {1e-2, 1e-3, 1e-4}) {
    DrawnBar bar;
    auto integrator = make_integrator("rkc2", bar, {.tolerance = tolerance});
    integrate(*integrator, 0, {0}, {1000});
    const double steady = std::pow(DrawnBar::draw / DrawnBar::A, 1 / DrawnBar::n);
    EXPECT_NEAR(DrawnBar::stress(1000, integrator->state()[0]), steady, 200 * tolerance);
    EXPECT_LE(integrator->counters().rejected_steps, integrator->counters().steps / 5) << tolerance;
  }
}

TEST(Rkc2, AJumpWithoutBreakpointIsRejectedUntilTheStepIsShort) {
  // From t = 1/3 on the rate is 1, else 0: the state is max(0, t - 1/3).
  struct Switched : LinearSystem {
    Switched() : LinearSystem({0.0}) {}
    void f(double t, std::span<const double>, std::span<double> rate) const override { rate[0] = t > 1.0 / 3 ? 1 : 0; }
  } system;
  auto integrator = make_integrator("rkc2", system, {.tolerance = 1e-4});
  integrator->initialize(0, Values{0}, 0.1);
  while (integrator->time() < 1) integrator->step(1);
  EXPECT_NEAR(integrator->state()[0], 2.0 / 3, 1e-3);
  EXPECT_GT(integrator->counters().rejected_steps, 0);
}

TEST(Rkc2, FailureForLackOfAccuracyNamesTheCure) {
  struct Noisy : LinearSystem {
    Noisy() : LinearSystem({0.0}) {}
    void f(double t, std::span<const double>, std::span<double> rate) const override {
      rate[0] = t > 0 ? std::numeric_limits<double>::max() / 1e10 : 0;
    }
  } noisy;
  auto integrator = make_integrator("rkc2", noisy, {.tolerance = 1e-4});
  integrator->initialize(0, Values{0}, 1e-3);
  try {
    integrator->step(1);
    FAIL() << "no step can be accurate";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("breakpoint"), std::string::npos) << error.what();
  }
  EXPECT_EQ(integrator->time(), 0);
}

}  // namespace
}  // namespace creepcontact::ode
