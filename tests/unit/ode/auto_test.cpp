/// integrator = "auto": what it changes to, when, and that nothing is lost on the way.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "creepcontact/base/log.hpp"
#include "unit/ode/systems.hpp"

namespace creepcontact::ode {
namespace auto_tests {
namespace {

const double tau = 1 / (ParallelBars::E * ParallelBars::n * 1e-14 * std::pow(ParallelBars::mean_stress, 4));

/// GMRES is told another Jacobian than that of f, with which Newton's iteration goes astray.
class MisleadingBars : public ParallelBars {
 public:
  using ParallelBars::ParallelBars;
  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override {
    ParallelBars::jacobian_times(t, y, v, product);
    for (double& value : product) value *= misleading ? 0.05 : 1.0;
  }
  NewtonSolver* newton_solver() override { return tangent ? this : nullptr; }
  bool misleading = true, tangent = true;
};

class Auto : public testing::Test {
 protected:
  Auto() { log::set_level(log::Level::error); }
  ~Auto() override { log::set_level(log::Level::info); }

  /// @returns the methods in their order
  static std::vector<std::string> run(Integrator& integrator, double end) {
    std::vector<std::string> methods{integrator.method()};
    while (integrator.time() < end) {
      integrator.step(end);
      if (integrator.method() != methods.back()) methods.push_back(integrator.method());
    }
    return methods;
  }
  /// As if log_adams had been left already.
  static void begin_with_bdf(Integrator& integrator, std::size_t size, double method = 0) {
    integrator.restore({.time = 0,
                        .next_step = 0,
                        .state = Values(size),
                        .memory = {{"auto.method", {method}},
                                   {"auto.chosen", {1}},
                                   {"auto.starting", {0}},
                                   {"auto.given_up", {}},
                                   {"auto.loads_since", {0}}}});
  }
  static void expect_steady(const ParallelBars& bars, std::span<const double> state, double tolerance) {
    const Values stress = bars.stress(state);
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(stress[i], bars.steady_stress(i), 3 * tolerance * ParallelBars::mean_stress) << i;
  }
};

const std::string functional = "log_adams", krylov = "cvode_bdf",
                  tangent = "cvode_bdf with linear_solver = \"tangent\"";

std::int64_t cost(const System& system) {
  return system.counters().rate_evaluations + system.counters().jacobian_products;
}

TEST_F(Auto, NeedsNoJacobianProductsWhileStressRelaxes) {
  const double end = 1e3 / (RelaxingBar::A * RelaxingBar::E * std::pow(RelaxingBar::initial_stress, 4));
  RelaxingBar bar, of_bdf;
  auto integrator = make_integrator("auto", bar, {.tolerance = 1e-4, .end_time = end});
  auto bdf = make_integrator("cvode_bdf", of_bdf, {.tolerance = 1e-4, .end_time = end});
  integrator->initialize(0, Values(1));
  bdf->initialize(0, Values(1));
  EXPECT_EQ(run(*integrator, end), std::vector{functional});
  run(*bdf, end);
  EXPECT_LT(cost(bar), cost(of_bdf));
  EXPECT_NEAR(RelaxingBar::stress(integrator->state()[0]), RelaxingBar::exact_stress(end), 0.05);
}

/// Constant stress: y' = 1 + y / 5, whatever the points would do by themselves.
class GrowingRate : public TestSystem {
 public:
  GrowingRate() : TestSystem(1, 1e-3) {}

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override { rate[0] = 1 + y[0] / 5; }
  void df(double, std::span<const double>, std::span<const double> v, std::span<double> product) const override {
    product[0] = v[0] / 5;
  }
  void local(double, std::span<const double>, std::span<double> diagonal) const override { diagonal[0] = -10; }
};

TEST_F(Auto, IntegratesInRealTimeWhereCreepDoesNotChangeTheStress) {
  GrowingRate system;
  auto integrator = make_integrator("auto", system, {.tolerance = 1e-3, .end_time = 3});
  integrator->initialize(0, Values(1));
  EXPECT_EQ(run(*integrator, 3), (std::vector<std::string>{"log_adams", "cvode_adams"}));  // from the first step on
  EXPECT_NEAR(integrator->state()[0], 5 * std::expm1(3.0 / 5), 2e-6);
  auto resumed = make_integrator("auto", system, {.tolerance = 1e-3, .end_time = 3});
  resumed->restore(integrator->save());
  EXPECT_EQ(resumed->method(), "cvode_adams");
}

/// Nothing relaxes before the first breakpoint: the choice waits.
TEST_F(Auto, ChoosesWhereStressMayRelax) {
  GrowingRate system;
  auto integrator = make_integrator("auto", system, {.tolerance = 1e-3, .end_time = 3});
  integrator->initialize(0, Values(1));
  EXPECT_EQ(run(*integrator, 0.1), std::vector<std::string>{"log_adams"});
  const Values reached(integrator->state().begin(), integrator->state().end());
  integrator->initialize(0.1, reached);
  EXPECT_EQ(run(*integrator, 3), (std::vector<std::string>{"log_adams", "cvode_adams"}));
}

TEST_F(Auto, TheChoiceKeepsTheCountsOfEarlierSteps) {
  GrowingRate system;
  auto integrator = make_integrator("auto", system, {.tolerance = 1e-3, .end_time = 3});
  integrator->initialize(0, Values(1));
  run(*integrator, 0.1);
  const std::int64_t steps = integrator->counters().steps;
  const Values reached(integrator->state().begin(), integrator->state().end());
  integrator->initialize(0.1, reached);
  integrator->step(3);
  ASSERT_EQ(integrator->method(), "cvode_adams");
  EXPECT_EQ(integrator->counters().steps, steps + 1);
}

TEST_F(Auto, TakesBdfBeforeManyStableStepsLieAhead) {
  const double end = 1e3 * tau;
  std::map<std::string, double> costs;
  for (const std::string name : {"auto", "cvode_bdf"}) {
    ParallelBars bars(20, 1e4);
    auto integrator = make_integrator(name, bars, {.tolerance = 1e-4, .end_time = end});
    integrator->initialize(0, Values(20));
    EXPECT_EQ(run(*integrator, end).back(), krylov);
    expect_steady(bars, integrator->state(), 1e-4);
    costs[name] = static_cast<double>(cost(bars));
  }
  EXPECT_LT(costs["auto"], 1.5 * costs["cvode_bdf"]);
}

TEST_F(Auto, TakesTheTangentWhereIterationsFail) {
  for (const double grading : {100.0, 1e5}) {
    MisleadingBars bars(20, grading);
    const double end = 100 * tau;
    auto integrator = make_integrator("auto", bars, {.tolerance = 1e-4, .end_time = end});
    begin_with_bdf(*integrator, 20);
    EXPECT_EQ(run(*integrator, end), (std::vector{krylov, tangent}));
    expect_steady(bars, integrator->state(), 1e-4);
    EXPECT_LT(bars.counters().rate_evaluations, 5000);
    EXPECT_GT(integrator->counters().convergence_failures, 6);  // those of the earlier methods are kept
  }
}

/// As if GMRES needed ten times the products.
class LaboriousBars : public ParallelBars {
 public:
  using ParallelBars::ParallelBars;
  Counters counters() const override {
    Counters many = ParallelBars::counters();
    many.jacobian_products *= 10;
    return many;
  }
  NewtonSolver* newton_solver() override { return tangent ? this : nullptr; }
  bool tangent = true;
};

TEST_F(Auto, TakesTheTangentWhereStepsNeedManyProducts) {
  const double end = 1e3 * tau;
  for (const bool has_tangent : {true, false}) {
    LaboriousBars bars(20, 1e5);
    bars.tangent = has_tangent;
    auto integrator = make_integrator("auto", bars, {.tolerance = 1e-9, .end_time = end});
    begin_with_bdf(*integrator, 20);
    const std::vector<std::string> methods = run(*integrator, end);
    EXPECT_EQ(methods.front(), krylov);
    EXPECT_EQ(std::count(methods.begin(), methods.end(), tangent), has_tangent ? 1 : 0);
    expect_steady(bars, integrator->state(), 1e-4);
  }
}

TEST_F(Auto, WithoutTangentGoesOnWithWhatThereIs) {
  MisleadingBars bars(20, 1e3);
  bars.tangent = false;
  const double end = 100 * tau;
  auto integrator = make_integrator("auto", bars, {.tolerance = 1e-3, .end_time = end});
  begin_with_bdf(*integrator, 20);
  const std::vector<std::string> methods = run(*integrator, end);
  EXPECT_EQ(std::count(methods.begin(), methods.end(), tangent), 0);
  expect_steady(bars, integrator->state(), 1e-3);
}

TEST_F(Auto, ResumesWithTheMethodAtWork) {
  MisleadingBars bars(20, 100);
  const double end = 30 * tau;
  const IntegratorOptions options{.tolerance = 1e-4, .end_time = end};
  auto integrator = make_integrator("auto", bars, options);
  begin_with_bdf(*integrator, 20);
  while (integrator->method() != tangent && integrator->time() < end) integrator->step(end);
  ASSERT_LT(integrator->time(), end);
  auto resumed = make_integrator("auto", bars, options);
  resumed->restore(integrator->save());
  EXPECT_EQ(resumed->method(), tangent);
  EXPECT_EQ(run(*resumed, end).size(), 1U);
  expect_steady(bars, resumed->state(), 1e-4);
}

TEST_F(Auto, ResumesFromACheckpointWithARemovedMethod) {
  ParallelBars bars(20, 100);
  const double end = 30 * tau;
  auto integrator = make_integrator("auto", bars, {.tolerance = 1e-4, .end_time = end});
  begin_with_bdf(*integrator, 20, 2);
  EXPECT_EQ(run(*integrator, end), std::vector{krylov});
  expect_steady(bars, integrator->state(), 1e-4);
}

}  // namespace
}  // namespace auto_tests
}  // namespace creepcontact::ode
