#include <gtest/gtest.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace {

double relaxation_error(const std::string& name, double beta, double step) {
  RelaxingBar bar;
  auto integrator = make_integrator(name, bar, {.step = step, .beta = beta, .inner_tolerance = 1e-15});
  integrate(*integrator, 0, {0}, {1.0});
  return std::abs(RelaxingBar::stress(integrator->state()[0]) - RelaxingBar::exact_stress(1));
}

TEST(Euler, ObservedOrderOfConvergence) {
  struct Case {
    const char* name;
    double beta, order;
  };
  for (const Case& scheme : {Case{"explicit_euler", 0.5, 1}, Case{"beta_euler", 1, 1}, Case{"beta_euler", 0.75, 1},
                             Case{"beta_euler", 0.5, 2}}) {
    const double coarse = relaxation_error(scheme.name, scheme.beta, 1.0 / 512);
    const double fine = relaxation_error(scheme.name, scheme.beta, 1.0 / 1024);
    EXPECT_NEAR(std::log2(coarse / fine), scheme.order, 0.05) << scheme.name << " beta = " << scheme.beta;
  }
}

TEST(Euler, ReportsTheOrder) {
  LinearSystem system({-1.0});
  for (const auto& [beta, order] : {std::pair{0.5, 2}, {1.0, 1}}) {
    auto integrator = make_integrator("beta_euler", system, {.step = 0.1, .beta = beta});
    integrator->initialize(0, Values{1});
    EXPECT_EQ(integrator->step(1).order, order);
  }
}

/// Linear relaxation; Cormeau's step is 2 / |lambda|.
double after_many_steps(double fraction_of_stable) {
  LinearSystem system({-1.0, -50.0});
  auto integrator = make_integrator("explicit_euler", system, {.step_factor = fraction_of_stable});
  integrator->initialize(0, Values{0, 1e-3});
  for (int k = 0; k < 400; ++k) integrator->step(1e9);
  return std::abs(integrator->state()[1]);
}

TEST(Euler, ExplicitIsStableBelowAndUnstableAboveTheCormeauStep) {
  EXPECT_LT(after_many_steps(0.98), 1e-6);
  EXPECT_GT(after_many_steps(1.02), 1);
}

TEST(Euler, ExplicitWarnsOfMoreThanOneStableStep) {
  for (const double factor : {1.0, 1.5}) {
    testing::internal::CaptureStderr();
    after_many_steps(factor);
    const bool warned = testing::internal::GetCapturedStderr().find("step_factor = 1 or less") != std::string::npos;
    EXPECT_EQ(warned, factor > 1) << factor;
  }
}

TEST(Euler, ExplicitNamesTheStableStepWhenTheStateOverflows) {
  LinearSystem system({-1.0});
  auto integrator = make_integrator("explicit_euler", system, {.step = 100});
  integrator->initialize(0, Values{1});
  try {
    for (int k = 0; k < 1000; ++k) integrator->step(1e9);
    FAIL() << "overflow not noticed";
  } catch (const SolverError& error) {
    EXPECT_TRUE(test::says(error.what(), {"stable step", " 2.", "step = \"stable\""}));
    EXPECT_TRUE(std::isfinite(integrator->state()[0]));
  }
}

TEST(Euler, StableStepFollowsTheRelaxation) {
  RelaxingBar bar;
  auto integrator = make_integrator("explicit_euler", bar, {.step_factor = 0.5});
  integrator->initialize(0, Values{0});
  double last = 0;
  for (int k = 0; k < 20; ++k) {
    const double expected = 0.5 * bar.stable_step(integrator->time(), integrator->state());
    const double step = integrator->step(1e9).step;
    EXPECT_NEAR(step, expected, 1e-12 * expected);
    EXPECT_GT(step, last);
    last = step;
  }
}

TEST(Euler, FixedStepsLeaveNoSliver) {
  LinearSystem system({-1e-3});
  for (const char* name : {"explicit_euler", "beta_euler"}) {
    auto integrator = make_integrator(name, system, {.step = 0.1});
    integrator->initialize(0, Values{1});
    for (double limit : {0.3, 1000.0, 1000.7, 2000.0})
      while (integrator->time() < limit) {
        const StepReport report = integrator->step(limit);
        ASSERT_NEAR(report.step, 0.1, 1e-9) << "t = " << report.time;
      }
    EXPECT_EQ(integrator->counters().steps, 20000) << name;
  }
}

TEST(Euler, LastStepIsShortened) {
  LinearSystem system({-1.0});
  auto integrator = make_integrator("explicit_euler", system, {.step = 0.4});
  integrator->initialize(0, Values{1});
  EXPECT_EQ(integrator->step(1).step, 0.4);
  EXPECT_EQ(integrator->step(1).step, 0.4);
  EXPECT_NEAR(integrator->step(1).step, 0.2, 1e-15);
  EXPECT_EQ(integrator->time(), 1);
  EXPECT_EQ(integrator->step(2).step, 0.4);
  EXPECT_NEAR(integrator->state()[0], 0.6 * 0.6 * 0.8 * 0.6, 1e-15);
}

TEST(Euler, ExplicitCostsOneEvaluationAStep) {
  LinearSystem system({-1.0});
  auto integrator = make_integrator("explicit_euler", system, {.step = 0.1});
  integrate(*integrator, 0, {1}, {1.0});
  EXPECT_EQ(system.counters().rate_evaluations, 11);
  EXPECT_EQ(system.calls_elsewhere, 0);
}

TEST(BetaEuler, InnerIterationsContractBelowTheBoundOnly) {
  // |lambda| = 1: the bound stable / (2 beta) is 1 / beta.
  for (double beta : {0.5, 1.0})
    for (double fraction : {0.9, 1.1}) {
      LinearSystem system({-1.0});
      auto integrator =
          make_integrator("beta_euler", system, {.step = fraction / beta, .beta = beta, .inner_tolerance = 1e-8});
      integrator->initialize(0, Values{1});
      if (fraction < 1) {
        integrator->step(100);
        const double dt = fraction / beta;
        EXPECT_NEAR(integrator->state()[0], (1 - (1 - beta) * dt) / (1 + beta * dt), 1e-7);
        continue;
      }
      try {
        integrator->step(100);
        FAIL() << "beta = " << beta;
      } catch (const SolverError& error) {
        const std::string message = error.what();
        for (const char* part : {"diverge", "stable / (2 beta)", "smaller step", "cvode_bdf"})
          EXPECT_NE(message.find(part), std::string::npos) << message;
        EXPECT_EQ(integrator->time(), 0);
        EXPECT_EQ(integrator->state()[0], 1);
      }
    }
}

TEST(BetaEuler, TooFewInnerIterationsAreReported) {
  LinearSystem system({-1.0});
  auto integrator = make_integrator("beta_euler", system, {.step = 0.9, .max_inner_iterations = 5});
  integrator->initialize(0, Values{1});
  EXPECT_THROW(integrator->step(100), SolverError);
  EXPECT_EQ(system.counters().rate_evaluations, 1 + 5);
}

/// Distance of the relaxed stress from the one with exact inner iterations, after many steps.
double drift(double gamma, double inner_tolerance) {
  const auto stress = [](double correction, double tolerance) {
    RelaxingBar bar;
    auto integrator = make_integrator(
        "beta_euler", bar, {.step = 0.015, .beta = 1, .inner_tolerance = tolerance, .residual_correction = correction});
    integrate(*integrator, 0, {0}, {15.0});
    return RelaxingBar::stress(integrator->state()[0]);
  };
  return std::abs(stress(gamma, inner_tolerance) - stress(1, 1e-16));
}

TEST(BetaEuler, ResidualCorrectionKeepsTheResidualFromAccumulating) {
  for (double tolerance : {1e-4, 1e-5, 1e-6}) {
    EXPECT_GT(drift(0, tolerance), 0) << tolerance;
    EXPECT_LT(drift(1, tolerance), 0.5 * drift(0, tolerance)) << tolerance;
  }
  EXPECT_LT(drift(0, 1e-15), 1e-6) << "with exact inner iterations there is no residual";
}

TEST(BetaEuler, ResidualCorrectionUsesTheResidualCorrection) {
  // One inner iteration a step, worked by hand: f(y) = -y, dt = 0.1, beta = 1, y_0 = 1.
  // Predictor 0.9, rate at e = 0.9, y_1 = 0.91, residual 0.01. Step 2: predictor 0.82, e = 0.82 - (1 - gamma) 0.01.
  for (double gamma : {0.0, 0.5, 1.0}) {
    LinearSystem system({-1.0});
    auto integrator = make_integrator("beta_euler", system,
                                      {.step = 0.1, .beta = 1, .inner_tolerance = 0.1, .residual_correction = gamma});
    integrator->initialize(0, Values{1});
    integrator->step(10);
    EXPECT_NEAR(integrator->state()[0], 0.91, 1e-15);
    integrator->step(10);
    EXPECT_NEAR(integrator->state()[0], 0.91 - 0.1 * (0.82 - (1 - gamma) * 0.01), 1e-15) << gamma;
  }
}

TEST(BetaEuler, ItsIterationsContractWithTheStepThatItChoosesItself) {
  for (const double beta : {0.5, 1.0}) {
    RelaxingBar bar;
    IntegratorOptions options{.tolerance = 1e-4};
    options.beta = beta;
    auto integrator = make_integrator("beta_euler", bar, options);
    const double end = 100 * bar.stable_step(0, Values(1));
    integrator->initialize(0, Values(1));
    while (integrator->time() < end) integrator->step(end);
    EXPECT_EQ(integrator->counters().convergence_failures, 0);
    EXPECT_NEAR(RelaxingBar::stress(integrator->state()[0]) / RelaxingBar::exact_stress(end), 1, 0.1)
        << beta;  // long steps
  }
}

}  // namespace
}  // namespace creepcontact::ode
