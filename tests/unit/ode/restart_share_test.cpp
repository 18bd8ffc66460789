#include "creepcontact/ode/restart_share.hpp"

#include <gtest/gtest.h>

namespace creepcontact::ode {
namespace {

TEST(RestartShare, IsAllWithFewRestarts) {
  for (const char* name : {"auto", "log_adams", "cvode_bdf", "cvode_adams", "arkode_dirk", "beta_euler"})
    EXPECT_EQ(restart_share(name, 12), 1) << name;
}

TEST(RestartShare, FallsWithTheirNumber) {
  for (const char* name : {"auto", "log_adams", "cvode_bdf", "cvode_adams"}) {
    EXPECT_LT(restart_share(name, 400), 0.3) << name;
    EXPECT_LT(restart_share(name, 4000), restart_share(name, 400)) << name;
    EXPECT_GE(restart_share(name, 1e9), 1e-5) << name;
  }
  EXPECT_EQ(restart_share("arkode_dirk", 4000), 1);
}

TEST(RestartShare, OfVibrations) {
  EXPECT_EQ(vibration_share(0), 1);
  EXPECT_EQ(vibration_share(100), 1);
  EXPECT_EQ(vibration_share(400), 0.25);
  EXPECT_EQ(vibration_share(1e9), 1e-3);
}

}  // namespace
}  // namespace creepcontact::ode
