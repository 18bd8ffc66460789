/// log_adams: what logarithmic time, the damped corrector and the restart are worth.

#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/ode/log_adams_history.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace {

TEST(LogAdams, TakesOneEvaluationPerStep) {
  RelaxingBar bar;
  auto integrator = make_integrator("log_adams", bar, {.tolerance = 1e-4, .end_time = 1e4});
  integrate(*integrator, 0, {0}, {1e4});
  const Integrator::Counters counters = integrator->counters();
  EXPECT_LE(bar.counters().rate_evaluations, counters.steps + counters.rejected_steps + 2);
  EXPECT_EQ(bar.counters().jacobian_products, 0);
  EXPECT_EQ(bar.calls_elsewhere, 0);
}

TEST(LogAdams, NeedsFewStepsPerDecadeOfRelaxation) {
  const double unit = 1 / (RelaxingBar::A * RelaxingBar::E * std::pow(RelaxingBar::initial_stress, 4));
  const auto cost = [&](const char* name) {
    RelaxingBar bar;
    auto integrator = make_integrator(name, bar, {.tolerance = 1e-4, .end_time = 1e6 * unit});
    integrate(*integrator, 0, {0}, {1e6 * unit});
    EXPECT_NEAR(RelaxingBar::stress(integrator->state()[0]), RelaxingBar::exact_stress(1e6 * unit), 0.02) << name;
    return bar.counters().rate_evaluations;
  };
  EXPECT_LT(2 * cost("log_adams"), cost("cvode_adams"));
}

TEST(LogAdams, PassesTheStableStepWhereCreepBecomesSteady) {
  ParallelBars bars(20, 1e2);
  const double end = 100 / (ParallelBars::E * ParallelBars::n * 1e-14 * std::pow(ParallelBars::mean_stress, 4));
  auto integrator = make_integrator("log_adams", bars, {.tolerance = 1e-3, .end_time = end});
  integrate(*integrator, 0, Values(20), {end});
  const Values stress = bars.stress(integrator->state());
  for (std::size_t i = 0; i < stress.size(); ++i) EXPECT_NEAR(stress[i], bars.steady_stress(i), 0.3);
  EXPECT_LT(bars.counters().rate_evaluations, 500);
}

TEST(LogAdams, RestoredAfterAnyStepItMakesTheSameOnes) {
  RelaxingBar bar;
  const IntegratorOptions options{.tolerance = 1e-4, .end_time = 100};
  auto saved = make_integrator("log_adams", bar, options);
  saved->initialize(0, Values{0});
  saved->step(100);
  while (saved->time() < 100) {
    auto restored = make_integrator("log_adams", bar, options);
    restored->restore(saved->save());
    EXPECT_EQ(restored->step(100).step, saved->step(100).step);
    EXPECT_EQ(restored->state()[0], saved->state()[0]);
  }
}

TEST(LogAdams, ConstantRatesAreExactHoweverLongTheStep) {
  const LogAdamsHistory history{.clock = {.origin = 0, .unit = 1}, .power = 0, .count = 1};
  for (const double t : {1e-3, 1.0, 1e3, 1e6, 1e9})
    EXPECT_NEAR(history.step_integrals(history.clock.at(t), 1)[0] / t, 1, 1e-12) << t;
}

TEST(LogAdams, SliversAddNothingToItsHistory) {
  LinearSystem system({-1.0});
  auto integrator = make_integrator("log_adams", system, {.tolerance = 1e-4});
  integrator->initialize(0, Values{1});
  while (integrator->time() < 1) integrator->step(1);
  const std::int64_t before = system.counters().rate_evaluations;
  integrator->step(1 + 5e-13);
  EXPECT_EQ(system.counters().rate_evaluations, before);
  integrator->step(1 + 1e-8);
  EXPECT_EQ(system.counters().rate_evaluations, before + 1) << "one shows that nothing happens in it";
  EXPECT_GT(integrator->step(10).step, 1e-2);
  EXPECT_NEAR(integrator->state()[0], std::exp(-integrator->time()), 1e-4);
}

}  // namespace
}  // namespace creepcontact::ode
