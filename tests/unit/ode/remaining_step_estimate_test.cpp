#include "../../../src/ode/remaining_step_estimate.hpp"

#include <gtest/gtest.h>

namespace creepcontact::ode {
namespace {

TEST(RemainingStepEstimate, OfASteadyRateAreCountedByTheTimeLeft) {
  RemainingStepEstimate steps;
  steps.begin(100);
  EXPECT_FALSE(steps.count(200).has_value());
  for (const double t : {101, 102, 105, 110}) steps.add(t, 0.5);
  EXPECT_NEAR(steps.count(200).value(), 90 / 0.5, 1e-9);
  EXPECT_NEAR(steps.decades(200), 1, 1e-12);
}

TEST(RemainingStepEstimate, ThatGrowWithTheTimeAreFewADecade) {
  RemainingStepEstimate steps;
  steps.begin(0);
  for (const double t : {1., 2., 5., 10.}) steps.add(t, 0.1 * t);
  EXPECT_NEAR(steps.count(1e6).value(), 10 * std::log(1e5), 1e-6);
}

TEST(RemainingStepEstimate, UntilTheTimeHasTripledTheFewestAreTaken) {
  RemainingStepEstimate steps;
  steps.begin(0);
  steps.add(1, 1);
  steps.add(2.9, 1);
  const double fewest = 2 * 2.9 * (1 - std::sqrt(2.9 / 10));  // they grow as the time to the power 1.5
  EXPECT_NEAR(steps.count(10).value(), fewest, 1e-12);
  steps.add(3.1, 1);
  EXPECT_NEAR(steps.count(10).value(), 6.9, 1e-12);
}

}  // namespace
}  // namespace creepcontact::ode
