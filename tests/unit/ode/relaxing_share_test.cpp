/// relaxing_share(): 1 between rigid grips, less where bars give way to each other, none where nothing creeps.

#include "../../../src/ode/relaxing_share.hpp"

#include <gtest/gtest.h>

#include "unit/ode/systems.hpp"

namespace creepcontact::ode {
namespace {

std::optional<double> share_of(System& system, double t, const Values& y) {
  return relaxing_share(system, t, y, system.stable_step(t, y));
}

TEST(RelaxingShare, IsOneBetweenRigidGrips) {
  RelaxingBar bar;
  EXPECT_NEAR(share_of(bar, 0, Values{0}).value(), 1, 1e-12);
  EXPECT_NEAR(share_of(bar, 0, Values{5e-4}).value(), 1, 1e-12);
}

TEST(RelaxingShare, IsZeroWhereAllBarsCreepAlike) {
  ParallelBars alike(20, 1), graded(20, 1e3);
  EXPECT_NEAR(share_of(alike, 0, Values(20)).value(), 0, 1e-12);
  EXPECT_GT(share_of(graded, 0, Values(20)).value(), 0.3);
  EXPECT_LT(share_of(graded, 0, Values(20)).value(), 1);
}

TEST(RelaxingShare, IsUnknownWhereNothingCreeps) {
  RelaxingBar bar;
  EXPECT_FALSE(share_of(bar, 0, Values{RelaxingBar::initial_stress / RelaxingBar::E}).has_value());
}

}  // namespace
}  // namespace creepcontact::ode
