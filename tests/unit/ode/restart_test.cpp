/// An integration taken up again from a restart point, as a resumed run does.

#include <algorithm>
#include <cmath>

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

using Restart = EveryIntegrator;

struct Step {
  double time, step;
  Values state;
  bool operator==(const Step&) const = default;
};

/// Steps to the end, with a restart in between at t = 1 as at a breakpoint.
std::vector<Step> go_on(Integrator& integrator, double end) {
  std::vector<Step> steps;
  while (integrator.time() < end) {
    const double limit = integrator.time() < 1 ? 1 : end;
    const StepReport report = integrator.step(limit);
    steps.push_back({report.time, report.step, {integrator.state().begin(), integrator.state().end()}});
    if (report.time == 1) integrator.initialize(1, steps.back().state);
  }
  return steps;
}

/// From every restart point of a run, a new integrator on a new system ends the run in the same way.
TEST_P(Restart, FromAnyRestartPoint) {
  constexpr double end = 2, tolerance = 1e-4;
  const Values lambda{-1.0, -7.0, -30.0}, begin{1, 2, 0.5};
  LinearSystem system(lambda, true);
  auto whole = make(system, tolerance);
  whole->initialize(0, begin);
  std::vector<RestartPoint> points{whole->save()};
  std::vector<std::size_t> before{0};  // steps up to each point
  std::vector<Step> steps;
  Values unused(3);
  while (whole->time() < end) {
    const StepReport report = whole->step(whole->time() < 1 ? 1 : end);
    steps.push_back({report.time, report.step, {whole->state().begin(), whole->state().end()}});
    whole->interpolate(report.time - 0.3 * report.step, unused);
    if (report.time == 1) whole->initialize(1, steps.back().state);
    if (!whole->at_restart_point()) continue;
    points.push_back(whole->save());
    before.push_back(steps.size());
  }
  ASSERT_GT(points.size(), 2U);
  for (std::size_t k = 0; k < points.size(); k += 1 + points.size() / 20) {
    LinearSystem fresh(lambda, true);
    auto resumed = make(fresh, tolerance);
    resumed->restore(points[k]);
    EXPECT_EQ(resumed->time(), points[k].time);
    const std::vector<Step> rest = go_on(*resumed, end);
    if (whole->restores_exactly()) {
      EXPECT_TRUE(std::equal(rest.begin(), rest.end(), steps.begin() + before[k], steps.end()))
          << "from t = " << points[k].time;
    } else if (!rest.empty()) {
      for (std::size_t i = 0; i < begin.size(); ++i)
        EXPECT_NEAR(rest.back().state[i], steps.back().state[i], 10 * tolerance) << "from t = " << points[k].time;
    }
  }
}

TEST_P(Restart, OnlyMultistepMethodsLoseTheirHistory) {
  LinearSystem system({-1.0});
  EXPECT_EQ(make(system)->restores_exactly(), !GetParam().starts_with("cvode") && GetParam() != "auto");
}

TEST_P(Restart, BeginsAnewWithoutWhatWasEvaluatedBefore) {
  struct Forgetful : LinearSystem {
    using LinearSystem::LinearSystem;
    void forget_evaluations() override { ++forgotten; }
    int forgotten = 0;
  } system({-1.0});
  auto integrator = make(system, 1e-6);
  integrator->initialize(0, Values{1});
  const RestartPoint begin = integrator->save();
  const int before = system.forgotten;
  integrator->restore(begin);
  EXPECT_GT(system.forgotten, before);
}

INSTANTIATE_TEST_SUITE_P(All, Restart, testing::ValuesIn(all_names()), test_name);

/// The residual of the inner iterations is part of the state that a step begins with.
TEST(RestartOfBetaEuler, KeepsTheResidualAndTheClock) {
  ParallelBars system(4, 100), fresh(4, 100);
  const IntegratorOptions options{.step = 0.1 * system.stable_step(0, Values(4)), .beta = 0.5, .inner_tolerance = 1e-6};
  auto whole = make_integrator("beta_euler", system, options), resumed = make_integrator("beta_euler", fresh, options);
  const double end = 1000.5 * options.step.length;
  whole->initialize(0, Values(4));
  for (int i = 0; i < 7; ++i) whole->step(end);
  resumed->restore(whole->save());
  for (int i = 0; i < 100; ++i) {
    whole->step(end);
    resumed->step(end);
  }
  EXPECT_EQ(resumed->time(), whole->time());
  EXPECT_TRUE(std::ranges::equal(resumed->state(), whole->state()));
  EXPECT_THROW(resumed->restore({.time = 0, .next_step = 0, .state = Values(4), .memory = {}}), std::out_of_range);
}

/// However often it is taken up anew, CVODE keeps the accuracy that the tolerance promises (three of them).
TEST(RestartOfCvode, KeepsTheAccuracy) {
  const double tolerance = 1e-4, end = 1000;
  for (const int every : {1, 10, 1000000}) {
    RelaxingBar system;
    auto integrator = make_integrator("cvode_bdf", system, {.tolerance = tolerance, .end_time = end});
    integrator->initialize(0, Values{0});
    double error = 0;
    for (int steps = 1; integrator->time() < end; ++steps) {
      const StepReport report = integrator->step(end);
      EXPECT_LT(report.error_estimate, 1);
      const double stress = RelaxingBar::stress(integrator->state()[0]);
      error = std::max(error, std::abs(stress - RelaxingBar::exact_stress(report.time)));
      if (steps % every == 0) integrator->restore(integrator->save());
    }
    EXPECT_LT(error, 3 * tolerance * RelaxingBar::initial_stress) << "every " << every;
  }
}

TEST(RestartOfArkode, CostsLittle) {
  for (const char* name : {"arkode_erk", "arkode_dirk"}) {
    std::int64_t cost[2]{};
    for (const bool often : {false, true}) {
      ParallelBars system(6, 100);
      IntegratorOptions options{.tolerance = 1e-6};
      if (!often) options.restart_interval = 1000000;
      auto integrator = make_integrator(name, system, options);
      const double end = 300 * system.stable_step(0, Values(6));
      integrator->initialize(0, Values(6));
      while (integrator->time() < end) integrator->step(end);
      EXPECT_GT(integrator->counters().steps, 100);
      cost[often ? 1 : 0] = system.counters().rate_evaluations + system.counters().jacobian_products;
    }
    RecordProperty(std::string(name) + "_evaluations", std::to_string(cost[0]) + " " + std::to_string(cost[1]));
    EXPECT_LT(static_cast<double>(cost[1]), 1.05 * static_cast<double>(cost[0])) << name << " " << cost[0];
  }
}

}  // namespace
}  // namespace creepcontact::ode
