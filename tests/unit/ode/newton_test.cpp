/// beta_euler with Newton's inner iterations, far beyond the bound of the fixed-point ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace {

constexpr double never = 1e9;

IntegratorOptions newton(StepChoice step, double beta = 1, double inner_tolerance = 1e-12) {
  return {.step = step, .beta = beta, .inner = InnerIteration::newton, .inner_tolerance = inner_tolerance};
}

/// Stress after a backward Euler step of the relaxing bar: s + E A s^n dt = s_n, by bisection.
double backward_euler_stress(double before, double dt) {
  double low = 0, high = before;
  for (int i = 0; i < 200; ++i) {
    const double s = 0.5 * (low + high);
    (s + RelaxingBar::E * RelaxingBar::A * std::pow(s, RelaxingBar::n) * dt > before ? high : low) = s;
  }
  return low;
}

TEST(InnerNewton, TakesStepsOfAThousandStableSteps) {
  for (double factor : {1.0, 1e3, 1e6}) {
    RelaxingBar bar;
    const double dt = factor * bar.stable_step(0, Values{0});
    auto integrator = make_integrator("beta_euler", bar, newton(dt));
    integrator->initialize(0, Values{0});
    double stress = RelaxingBar::initial_stress;
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(integrator->step(never).step, dt);
      stress = backward_euler_stress(stress, dt);
      EXPECT_NEAR(RelaxingBar::stress(integrator->state()[0]), stress, 1e-9 * RelaxingBar::initial_stress) << factor;
    }
    EXPECT_EQ(integrator->counters().convergence_failures, 0);
    EXPECT_EQ(bar.calls_elsewhere, 0) << "Jacobian and preconditioner belong to the last evaluation";
    EXPECT_LT(bar.counters().rate_evaluations, 150) << factor;
    RecordProperty("rates_and_products_" + std::to_string(factor),
                   static_cast<int>(bar.counters().rate_evaluations + bar.counters().jacobian_products));
  }
}

TEST(InnerNewton, SolvesTheEquationOfTheStepForCoupledBars) {
  constexpr double tolerance = 1e-10;
  constexpr std::size_t bars_side_by_side = 30;
  for (double beta : {0.5, 1.0})
    for (double factor : {1.0, 100.0, 1e3, 1e5}) {
      ParallelBars bars(bars_side_by_side, 1e4);
      const Values start(bars_side_by_side);
      const double dt = factor * bars.stable_step(0, start);
      auto integrator = make_integrator("beta_euler", bars, newton(dt, beta, tolerance));
      integrator->initialize(0, start);
      integrator->step(never);
      EXPECT_EQ(integrator->time(), dt) << "no shorter step";
      // One more Newton step of the exact Jacobian, to measure the error: y - G(y) is amplified by the stiffness.
      const Values y(integrator->state().begin(), integrator->state().end());
      Values f0(y.size()), f(y.size());
      bars.rate(0, start, f0);
      bars.rate(dt, y, f);
      const Values stress = bars.stress(y);
      double worst = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const double residual = dt * ((1 - beta) * f0[i] + beta * f[i]) - y[i];
        const double stiffness = 1 + beta * dt * ParallelBars::E * ParallelBars::n * std::abs(f[i] / stress[i]);
        worst = std::max(worst, std::abs(residual) / stiffness);
      }
      EXPECT_LT(worst, 3 * tolerance) << "beta = " << beta << ", " << factor << " stable steps";
      EXPECT_EQ(bars.calls_elsewhere, 0);
    }
}

TEST(InnerNewton, CreepThatChangesNoStressIsNotHidden) {
  // Equal bars: all creep alike at constant stress, y = f t, a mode that the point-wise preconditioner takes for stiff.
  ParallelBars bars(10, 1);
  const Values start(10);
  const double dt = 1e4 * bars.stable_step(0, start);
  auto integrator = make_integrator("beta_euler", bars, newton(dt));
  integrator->initialize(0, start);
  Values rate(10);
  bars.rate(0, start, rate);
  for (int k = 1; k <= 3; ++k) {
    integrator->step(never);
    const double exact = k * dt * rate[0];
    // Stress is the difference of strains: their last digit counts for the rate n E / stress times as much.
    const double rounding = std::numeric_limits<double>::epsilon() * exact * exact * ParallelBars::n * ParallelBars::E /
                            ParallelBars::mean_stress;
    for (double y : integrator->state()) EXPECT_NEAR(y, exact, 1e-11 + rounding);
  }
}

TEST(InnerNewton, GivesTheSolutionOfTheFixedPoint) {
  for (double beta : {0.5, 0.75, 1.0})
    for (double gamma : {0.0, 1.0}) {
      ParallelBars plain(8, 100), again(8, 100);
      IntegratorOptions options = newton(0.2 * plain.stable_step(0, Values(8)) / (2 * beta), beta, 1e-13);
      options.residual_correction = gamma;
      auto by_newton = make_integrator("beta_euler", again, options);
      options.inner = InnerIteration::fixed_point;
      auto by_fixed_point = make_integrator("beta_euler", plain, options);
      by_newton->initialize(0, Values(8));
      by_fixed_point->initialize(0, Values(8));
      for (int k = 0; k < 20; ++k) {
        by_newton->step(never);
        by_fixed_point->step(never);
      }
      for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(by_newton->state()[i], by_fixed_point->state()[i], 40 * 1e-13) << "beta = " << beta;
    }
}

TEST(InnerNewton, LongStepsAreInterpolatedBetweenTheirEnds) {
  for (const double beta : {0.5, 0.75, 1.0}) {
    RelaxingBar bar;
    const double dt = 1e3 * bar.stable_step(0, Values{0});
    auto integrator = make_integrator("beta_euler", bar, newton(dt, beta));
    integrator->initialize(0, Values{0});
    for (int k = 0; k < 3; ++k) {
      const double begin = integrator->time();
      const double from = integrator->state()[0];
      integrator->step(never);
      const auto [low, high] = std::minmax({from, integrator->state()[0]});
      Values y(1);
      for (const double theta : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        integrator->interpolate(begin + theta * dt, y);
        EXPECT_GE(y[0], low) << "beta = " << beta << ", theta = " << theta;
        EXPECT_LE(y[0], high) << "beta = " << beta << ", theta = " << theta;
      }
    }
  }
}

TEST(InnerNewton, ObservedOrderOfConvergence) {
  for (const auto& [beta, order] : {std::pair{1.0, 1}, {0.75, 1}, {0.5, 2}}) {
    const auto error = [beta = beta](double step) {
      RelaxingBar bar;
      auto integrator = make_integrator("beta_euler", bar, newton(step, beta, 1e-15));
      integrate(*integrator, 0, {0}, {1.0});
      return std::abs(RelaxingBar::stress(integrator->state()[0]) - RelaxingBar::exact_stress(1));
    };
    EXPECT_NEAR(std::log2(error(1.0 / 512) / error(1.0 / 1024)), order, 0.05) << "beta = " << beta;
  }
}

TEST(InnerNewton, TheToleranceBoundsTheErrorOfTheStep) {
  for (double tolerance : {1e-6, 1e-8, 1e-10}) {
    RelaxingBar bar;
    const double dt = 100 * bar.stable_step(0, Values{0});
    auto integrator = make_integrator("beta_euler", bar, newton(dt, 1, tolerance));
    integrator->initialize(0, Values{0});
    integrator->step(never);
    const double stress = backward_euler_stress(RelaxingBar::initial_stress, dt);
    EXPECT_NEAR(RelaxingBar::stress(integrator->state()[0]), stress, RelaxingBar::E * tolerance);
  }
}

TEST(InnerNewton, AdaptiveStepsAreNotBoundByTheStiffness) {
  constexpr double tolerance = 1e-3;
  const double tau = 1 / (ParallelBars::E * 1e-14 * 1e8);  // relaxation time of the slowest bar
  for (double beta : {0.5, 1.0}) {
    ParallelBars bars(30, 1e4);
    IntegratorOptions options = newton(StepMode::adaptive, beta, 1e-9);
    options.tolerance = tolerance;
    options.end_time = 100 * tau;
    auto integrator = make_integrator("beta_euler", bars, options);
    integrator->initialize(0, Values(30));
    double longest = 0;  // in stable steps
    while (integrator->time() < options.end_time) {
      const double stable = bars.stable_step(integrator->time(), integrator->state());
      longest = std::max(longest, integrator->step(options.end_time).step / stable);
    }
    EXPECT_GT(longest, 1000) << "beta = " << beta;
    EXPECT_EQ(integrator->counters().convergence_failures, 0);
    const Values stress = bars.stress(integrator->state());
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(stress[i], bars.steady_stress(i), 10 * tolerance * ParallelBars::mean_stress) << beta;
  }
}

TEST(InnerNewton, FailureShortensTheStepAndSaysWhy) {
  RelaxingBar bar;
  IntegratorOptions options = newton(1e3 * bar.stable_step(0, Values{0}));
  options.max_inner_iterations = 2;
  auto integrator = make_integrator("beta_euler", bar, options);
  integrator->initialize(0, Values{0});
  try {
    integrator->step(never);
    EXPECT_LT(integrator->time(), options.step.length);
    EXPECT_GT(integrator->counters().convergence_failures, 0);
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("Newton"), std::string::npos) << error.what();
    EXPECT_EQ(integrator->state()[0], 0);
  }
}

TEST(InnerNewton, ExceptionsComeThroughFromTheLinearSolver) {
  struct Broken : RelaxingBar {
    void df(double, std::span<const double>, std::span<const double>, std::span<double>) const override {
      throw std::logic_error("out of order");
    }
  } bar;
  auto integrator = make_integrator("beta_euler", bar, newton(0.1));
  integrator->initialize(0, Values{0});
  EXPECT_THROW(integrator->step(never), std::logic_error);
  EXPECT_EQ(integrator->time(), 0);
}

TEST(InnerNewton, TakesNoAnderson) {
  RelaxingBar bar;
  IntegratorOptions options = newton(0.1);
  options.inner_anderson = 3;
  EXPECT_THROW(make_integrator("beta_euler", bar, options), ConfigError);
}

}  // namespace
}  // namespace creepcontact::ode
