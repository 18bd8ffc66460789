#include "creepcontact/model/step_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace creepcontact::model {
namespace {

TEST(StepLimits, None) {
  EXPECT_TRUE(StepLimits().empty());
  EXPECT_TRUE(std::isinf(StepLimits().latest_end(3)));
}

TEST(StepLimits, HoldInsideAndBeforeTheirIntervals) {
  const StepLimits limits({{10, 20, 2}, {15, 16, 0.5}, {30, 40, 1}});
  EXPECT_EQ(limits.latest_end(0), 12);
  EXPECT_EQ(limits.latest_end(10), 12);
  EXPECT_EQ(limits.latest_end(14), 15.5);
  EXPECT_EQ(limits.latest_end(15.2), 15.7);
  EXPECT_EQ(limits.latest_end(16), 18);
  EXPECT_EQ(limits.latest_end(20), 31);
  EXPECT_EQ(limits.latest_end(35), 36);
  EXPECT_TRUE(std::isinf(limits.latest_end(40)));
  EXPECT_NEAR(limits.n_steps(), 4.5 + 2 + 10, 1e-12);
}

}  // namespace
}  // namespace creepcontact::model
