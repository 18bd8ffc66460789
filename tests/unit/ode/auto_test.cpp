/// integrator = "auto": what it changes to, when, and that nothing is lost on the way.

#include <gtest/gtest.h>

#include "creepcontact/base/log.hpp"
#include "unit/ode/systems.hpp"

namespace creepcontact::ode {
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
  bool offers_tangent() const override { return tangent; }
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
  static void expect_steady(const ParallelBars& bars, std::span<const double> state, double tolerance) {
    const Values stress = bars.stress(state);
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(stress[i], bars.steady_stress(i), 3 * tolerance * ParallelBars::mean_stress) << i;
  }
};

const std::string krylov = "cvode_bdf", tangent = "cvode_bdf with linear_solver = \"tangent\"", stabilized = "rkc2";

TEST_F(Auto, IsCvodeBdfWhereThatSucceeds) {
  const double end = 1e3 * tau;
  std::int64_t cost[2];
  for (const char* name : {"auto", "cvode_bdf"}) {
    ParallelBars bars(20, 1e4);
    auto integrator = make_integrator(name, bars, {.tolerance = 1e-4, .end_time = end});
    integrator->initialize(0, Values(20));
    EXPECT_EQ(run(*integrator, end), std::vector{krylov});
    expect_steady(bars, integrator->state(), 1e-4);
    cost[name == std::string("auto")] = bars.counters().rate_evaluations + bars.counters().jacobian_products;
  }
  EXPECT_EQ(cost[0], cost[1]);
}

TEST_F(Auto, LeavesIterationsThatFailForStabilisedStepsWhereTheseAreModerate) {
  MisleadingBars bars(20, 10);
  const double end = 10 * tau;
  auto integrator = make_integrator("auto", bars, {.tolerance = 1e-4, .end_time = end});
  integrator->initialize(0, Values(20));
  EXPECT_EQ(run(*integrator, end), (std::vector{krylov, stabilized}));
  expect_steady(bars, integrator->state(), 1e-4);
  EXPECT_GT(integrator->counters().convergence_failures, 3);  // those of the first method are kept
}

TEST_F(Auto, TakesTheTangentWhereStabilisedStepsHaveTooManyStages) {
  MisleadingBars bars(20, 1e5);
  const double end = 1e3 * tau;
  auto integrator = make_integrator("auto", bars, {.tolerance = 1e-4, .end_time = end});
  integrator->initialize(0, Values(20));
  EXPECT_EQ(run(*integrator, end).back(), tangent);
  expect_steady(bars, integrator->state(), 1e-4);
  EXPECT_LT(bars.counters().rate_evaluations, 3000);
}

TEST_F(Auto, WithoutTangentGoesOnWithWhatThereIs) {
  MisleadingBars bars(20, 1e3);
  bars.tangent = false;
  const double end = 100 * tau;
  auto integrator = make_integrator("auto", bars, {.tolerance = 1e-3, .end_time = end});
  integrator->initialize(0, Values(20));
  const std::vector<std::string> methods = run(*integrator, end);
  EXPECT_EQ(std::count(methods.begin(), methods.end(), tangent), 0);
  expect_steady(bars, integrator->state(), 1e-3);
}

TEST_F(Auto, ResumesWithTheMethodAtWork) {
  MisleadingBars bars(20, 10);
  const double end = 10 * tau;
  const IntegratorOptions options{.tolerance = 1e-4, .end_time = end};
  auto integrator = make_integrator("auto", bars, options);
  integrator->initialize(0, Values(20));
  while (integrator->method() != stabilized && integrator->time() < end) integrator->step(end);
  ASSERT_LT(integrator->time(), end);
  auto resumed = make_integrator("auto", bars, options);
  resumed->restore(integrator->save());
  EXPECT_EQ(resumed->method(), stabilized);
  EXPECT_EQ(run(*resumed, end).size(), 1U);
  expect_steady(bars, resumed->state(), 1e-4);
}

}  // namespace
}  // namespace creepcontact::ode
