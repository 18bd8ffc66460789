/// The Euler schemes under error control by step doubling.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace {

constexpr double local_share = 0.4;  ///< of the tolerance, for local errors

IntegratorOptions adaptive(double tolerance, double beta = 1) {
  return {.tolerance = tolerance, .step = StepMode::adaptive, .beta = beta, .inner_tolerance = 1e-14};
}

TEST(AdaptiveEuler, TakesTwoHalvesAndReportsTheirError) {
  // y' = -y, one step h = 0.1 from y = 1, by hand.
  LinearSystem system({-1.0});
  auto integrator = make_integrator("explicit_euler", system, adaptive(0.1));
  integrator->initialize(0, Values{1}, 0.1);
  const StepReport report = integrator->step(10);
  EXPECT_EQ(report.step, 0.1);
  EXPECT_NEAR(integrator->state()[0], 0.95 * 0.95, 1e-15);
  EXPECT_NEAR(report.error_estimate, (0.95 * 0.95 - 0.9) / (local_share * 0.1), 1e-12);
  EXPECT_EQ(system.counters().rate_evaluations, 3) << "start, middle, end";

  LinearSystem again({-1.0});
  auto trapezoidal = make_integrator("beta_euler", again, adaptive(0.1, 0.5));
  trapezoidal->initialize(0, Values{1}, 0.1);
  const double half = (1 - 0.025) / (1 + 0.025), whole = (1 - 0.05) / (1 + 0.05);
  EXPECT_NEAR(trapezoidal->step(10).error_estimate, std::abs(half * half - whole) / 3 / (local_share * 0.1), 1e-10);
  EXPECT_NEAR(trapezoidal->state()[0], half * half, 1e-13);
}

/// The estimate against the true error of single steps from the exact solution.
TEST(AdaptiveEuler, TheEstimateIsTheErrorOfTheStep) {
  struct Case {
    const char* name;
    double beta;
  };
  for (const Case& scheme : {Case{"explicit_euler", 1}, Case{"beta_euler", 1}, Case{"beta_euler", 0.5}})
    for (double h : {0.02, 0.01}) {
      LinearSystem system({-1.0});
      auto integrator = make_integrator(scheme.name, system, adaptive(1, scheme.beta));
      integrator->initialize(0, Values{1}, h);
      const double estimate = integrator->step(10).error_estimate;
      const double error = std::abs(integrator->state()[0] - std::exp(-h));
      EXPECT_NEAR(local_share * estimate / error, 1, 2 * h) << scheme.name << " beta = " << scheme.beta;
    }
}

TEST(AdaptiveEuler, ErrorFollowsTheTolerance) {
  // Errors of all steps add up: tolerance^(p / (p + 1)).
  struct Case {
    const char* name;
    double beta, coarse, fine, power;
  };
  for (const Case& c : {Case{"explicit_euler", 1, 1e-5, 1e-7, 0.5}, Case{"beta_euler", 1, 1e-5, 1e-7, 0.5},
                        Case{"beta_euler", 0.5, 1e-6, 1e-9, 2.0 / 3}}) {
    const auto error = [&](double tolerance) {
      RelaxingBar bar;
      auto integrator = make_integrator(c.name, bar, adaptive(tolerance, c.beta));
      integrate(*integrator, 0, {0}, {1.0});
      return std::abs(RelaxingBar::stress(integrator->state()[0]) - RelaxingBar::exact_stress(1));
    };
    EXPECT_NEAR(std::log(error(c.coarse) / error(c.fine)) / std::log(c.coarse / c.fine), c.power, 0.05)
        << c.name << " beta = " << c.beta;
  }
}

TEST(AdaptiveEuler, StepsGrowWithTheRelaxation) {
  for (const char* name : {"explicit_euler", "beta_euler"}) {
    RelaxingBar bar;
    auto integrator = make_integrator(name, bar, adaptive(1e-4));
    integrator->initialize(0, Values{0});
    const double first = integrator->step(1000).step;
    double largest = 0;
    while (integrator->time() < 1000) largest = std::max(largest, integrator->step(1000).step);
    EXPECT_GT(largest, 1000 * first) << name;
    EXPECT_LE(integrator->counters().rejected_steps, integrator->counters().steps / 10) << name;
  }
}

TEST(AdaptiveEuler, ExplicitStepsStayStableWithoutRejections) {
  LinearSystem system({-1e-3, -1.0});
  auto integrator = make_integrator("explicit_euler", system, adaptive(0.1));
  integrator->initialize(0, Values{1, 1});
  while (integrator->time() < 300) EXPECT_LE(integrator->step(300).step, 2 * 2.0) << "two stable halves";
  EXPECT_LT(std::abs(integrator->state()[1]), 1e-6);
  EXPECT_LE(integrator->counters().rejected_steps, 2);
}

TEST(AdaptiveEuler, FixedPointStepsStayWhereTheyContract) {
  for (int depth : {0, 3}) {
    ParallelBars bars(8, 100);
    IntegratorOptions options = adaptive(1e-2);
    options.inner_anderson = depth;
    options.inner_tolerance = 1e-10;
    auto integrator = make_integrator("beta_euler", bars, options);
    integrator->initialize(0, Values(8));
    const double end = 200 * bars.stable_step(0, Values(8));
    while (integrator->time() < end) integrator->step(end);
    EXPECT_EQ(integrator->counters().convergence_failures, 0) << depth;
  }
}

TEST(AdaptiveEuler, StepsThatDoNotConvergeAreShortened) {
  LinearSystem system({-1.0});
  IntegratorOptions options = adaptive(1);
  options.max_inner_iterations = 3;  // not enough for the step that accuracy allows
  options.inner_tolerance = 1e-6;
  auto integrator = make_integrator("beta_euler", system, options);
  integrator->initialize(0, Values{1}, 0.5);
  EXPECT_LT(integrator->step(10).step, 0.1);
  EXPECT_GT(integrator->counters().convergence_failures, 0);
}

TEST(AdaptiveEuler, NeedsATolerance) {
  LinearSystem system({-1.0});
  EXPECT_THROW(make_integrator("explicit_euler", system, adaptive(0)), ConfigError);
  EXPECT_NO_THROW(make_integrator("explicit_euler", system, {.tolerance = 0, .step = 0.1}));
}

}  // namespace
}  // namespace creepcontact::ode
