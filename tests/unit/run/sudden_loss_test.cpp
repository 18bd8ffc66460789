#include "../../../src/run/observers/sudden_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace creepcontact::run {
namespace sudden_loss_tests {
namespace {

constexpr double heating = 0.01;  // a window of 1

/// Creep takes the force from 10 to 4 up to t = 1000; then all is lost within `duration`.
std::optional<SuddenLoss::Loss> lost_within(double duration, std::vector<double> load_changes = {}) {
  SuddenLoss loss(heating, std::move(load_changes));
  for (int k = 0; k <= 1000; ++k)
    if (const auto early = loss.observe(k, 10 - 6e-3 * k)) return early;
  for (int k = 1; k <= 20; ++k)
    if (const auto found = loss.observe(1000 + duration * k / 20, 4 * (1 - k / 20.0))) return found;
  return std::nullopt;
}

TEST(SuddenLoss, IsToldFromCreep) {
  const auto fold = lost_within(0.5);
  ASSERT_TRUE(fold);
  EXPECT_NEAR(fold->time, 1000.5, 1e-9);
  EXPECT_NEAR(fold->force, 4, 0.01);
  EXPECT_NEAR(fold->share, 0.4, 0.001);
  EXPECT_NEAR(fold->since, 1000.25, 0.026) << "within a step";
  EXPECT_FALSE(lost_within(200)) << "creep";
}

TEST(SuddenLoss, IsNotWhatALoadDoes) {
  EXPECT_FALSE(lost_within(0.5, {1000}));
  EXPECT_TRUE(lost_within(0.5, {500, 1100}));
}

TEST(SuddenLoss, IsFoundAfterARestart) {
  SuddenLoss before(heating, {});
  for (int k = 0; k <= 1000; ++k) before.observe(k, 10);
  before.observe(1000.2, 6);
  Memory memory;
  memory.save("fit", before.past());
  SuddenLoss::Past past;
  memory.restore("fit", past);
  SuddenLoss after(heating, {});
  after.go_on_from(past);
  const auto loss = after.observe(1000.3, 0);
  ASSERT_TRUE(loss);
  EXPECT_EQ(loss->share, 1);
  EXPECT_EQ(loss->since, 1000.2);
  EXPECT_FALSE(after.observe(1000.4, 0)) << "once";
}

}  // namespace
}  // namespace sudden_loss_tests
}  // namespace creepcontact::run
