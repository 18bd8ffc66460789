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

/// A bar under a constant load: eps' = rate (1 + growth w), w' = 1. Between rigid grips it would relax within a unit of
/// time. With growth > 0 w is damage; with growth < 0 it stands for hardening.
class ChangingBar final : public TestSystem {
 public:
  explicit ChangingBar(double growth) : TestSystem(2, 5e-4), growth_(growth) {}

 protected:
  static constexpr double rate = 1e-4;
  void f(double, std::span<const double> y, std::span<double> into) const override {
    into[0] = rate * (1 + growth_ * y[1]);
    into[1] = 1;
  }
  void df(double, std::span<const double>, std::span<const double> v, std::span<double> product) const override {
    product[0] = rate * growth_ * v[1];
    product[1] = 0;
  }
  void local(double, std::span<const double>, std::span<double> diagonal) const override {
    diagonal[0] = -1;
    diagonal[1] = 0;
  }

 private:
  double growth_;
};

TEST(RelaxingShare, DamageIsNoRelaxation) {
  for (const double growth : {0.2, 1.0, 5.0}) {
    ChangingBar bar(growth);
    EXPECT_EQ(relaxing_share(bar, 0, Values{0, 0}, 1).value(), 0) << growth;
  }
  ChangingBar hardening(-0.5);
  EXPECT_GT(relaxing_share(hardening, 0, Values{0, 0}, 1).value(), 0.3);
}

TEST(RelaxingShare, IsUnknownWhereNothingCreeps) {
  RelaxingBar bar;
  EXPECT_FALSE(share_of(bar, 0, Values{RelaxingBar::initial_stress / RelaxingBar::E}).has_value());
}

}  // namespace
}  // namespace creepcontact::ode
