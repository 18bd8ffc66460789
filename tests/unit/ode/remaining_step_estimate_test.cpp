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

TEST(RemainingStepEstimate, AreUnknownUntilTheTimeHasTripled) {
  RemainingStepEstimate steps;
  steps.begin(0);
  steps.add(1, 1);
  steps.add(2.9, 1);
  EXPECT_FALSE(steps.count(10).has_value());
  steps.add(3.1, 1);
  EXPECT_TRUE(steps.count(10).has_value());
}

}  // namespace
}  // namespace creepcontact::ode
