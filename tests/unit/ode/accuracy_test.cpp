#include <algorithm>
#include <cmath>

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

TEST_P(EveryIntegrator, SolvesExponentialDecay) {
  for (double tolerance : {1e-3, 1e-4}) {
    LinearSystem system({-1.0});
    auto integrator = make(system, tolerance);
    const Values times = {0.1, 1, 5};
    const auto y = integrate(*integrator, 0, {1}, times);
    for (std::size_t k = 0; k < times.size(); ++k)
      EXPECT_NEAR(y[k][0], std::exp(-times[k]), 20 * tolerance) << "t = " << times[k];
  }
}

TEST_P(EveryIntegrator, SolvesStiffLinearSystem) {
  LinearSystem system({-1, -100}, true);
  auto integrator = make(system, 1e-3);
  const Values times = {0.01, 1, 3};
  const auto y = integrate(*integrator, 0, {0, 2}, times);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_NEAR(y[k][0], system.exact(0, times[k], 0), 2e-2) << "t = " << times[k];
    EXPECT_NEAR(y[k][1], system.exact(1, times[k], 2), 2e-2) << "t = " << times[k];
  }
}

double worst_relaxation_error(const std::string& name, double tolerance) {
  RelaxingBar bar;
  IntegratorOptions options = accurate_options(name, tolerance);
  options.end_time = 1000;
  auto integrator = make_variant(name, bar, options);
  const Values times = {0.1, 1, 5, 10, 50, 100, 500, 1000};
  const auto y = integrate(*integrator, 0, {0}, times);
  double worst = 0;
  for (std::size_t k = 0; k < times.size(); ++k)
    worst = std::max(worst, std::abs(RelaxingBar::stress(y[k][0]) - RelaxingBar::exact_stress(times[k])));
  return worst / RelaxingBar::initial_stress;
}

TEST_P(EveryIntegrator, RelaxesBarWithinTolerance) {
  EXPECT_NEAR(RelaxingBar::exact_stress(1000), 14.14, 5e-3);
  EXPECT_NEAR(RelaxingBar::exact_stress(0.1), 133.75, 5e-3);
  const double coarse = worst_relaxation_error(GetParam(), 1e-3);
  const double fine = worst_relaxation_error(GetParam(), 1e-5);
  EXPECT_LT(coarse, 1e-2);
  EXPECT_LT(fine, 1e-4);
  EXPECT_LT(fine, coarse / 10) << "the error does not follow the tolerance";
}

TEST_P(EveryIntegrator, KnowsItsNameAndEmptySystems) {
  LinearSystem system({});
  auto integrator = make(system);
  EXPECT_EQ(integrator->name(), registered_name(GetParam()));
  integrator->initialize(0, {}, 0);
  // Euler's stable step of a system in which nothing happens is infinite.
  while (integrator->time() < 10) integrator->step(10);
  EXPECT_EQ(integrator->time(), 10);
  EXPECT_TRUE(integrator->state().empty());
}

TEST_P(EveryIntegrator, AcceptsEveryStepOnce) {
  LinearSystem system({-1.0, -2.0});
  auto integrator = make(system, 1e-3);
  integrator->initialize(0, Values{1, 1});
  for (int k = 0; k < 5; ++k) {
    const StepReport report = integrator->step(2);
    ASSERT_EQ(system.accepted_times.size(), k + 1);
    EXPECT_EQ(system.accepted_times.back(), report.time);
    EXPECT_EQ(report.time, integrator->time());
    EXPECT_TRUE(std::ranges::equal(system.accepted, integrator->state()));
    EXPECT_GT(report.order, 0);
  }
  EXPECT_EQ(integrator->counters().steps, 5);
}

TEST_P(EveryIntegrator, ErrorEstimateIsInUnitsOfTheTolerance) {
  LinearSystem system({-1.0, -1.0});
  auto integrator = make(system, 1e-4);
  integrator->initialize(0, Values{1, 1});
  double largest = 0;
  while (integrator->time() < 3) {
    const double estimate = integrator->step(3).error_estimate;
    EXPECT_GE(estimate, 0);
    EXPECT_LE(estimate, 1) << "an accepted step has passed the error test";
    largest = std::max(largest, estimate);
  }
  if (is_euler(GetParam()))
    EXPECT_EQ(largest, 0);
  else
    EXPECT_GT(largest, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Accuracy, EveryIntegrator, testing::ValuesIn(all_names()), test_name);

}  // namespace
}  // namespace creepcontact::ode
