/// The summary tells forces and stresses at the start, at their largest and at the end, and when a contact opened.
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace outcome_tests {
namespace {

const std::string contact = "contacts/lower_top-upper_bottom/";

/// Pressed, held, then lifted by more than creep has taken: with an area of 2 the force starts with 2.
TEST(Outcome, TellsForcesAndStressesAndWhenAContactOpened) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe,
      {"supports.3.displacement.z={t=[0, 1, 2, 4], values=[-0.025, -0.025, 0.01, 0.01]}", "time.output=[1, 1.9, 2.5]"});
  const Summary result = run(config, {.output = (blocks / "out").string()});
  ASSERT_EQ(result.exit_status, 0) << result.message;
  const SummaryFile summary(blocks / "out/summary.json");
  EXPECT_NEAR(summary.number(contact + "initial_normal_force"), 2, 1e-6);
  EXPECT_NEAR(summary.number(contact + "largest_normal_force"), 2, 1e-6);
  EXPECT_EQ(summary.number(contact + "final_normal_force"), 0);
  // The step in which the gap of 0.025 less what creep has taken opens, at the latest the next output.
  EXPECT_GT(summary.number(contact + "opened"), 1.5);
  EXPECT_LT(summary.number(contact + "opened"), 1.9);
  for (const char* body : {"lower", "upper"}) {
    const std::string of_body = std::string("bodies/") + body + '/';
    EXPECT_NEAR(summary.number(of_body + "initial_von_mises"), 1, 1e-6);
    EXPECT_NEAR(summary.number(of_body + "largest_von_mises"), 1, 1e-6);
    EXPECT_NEAR(summary.number(of_body + "final_von_mises"), 0, 1e-6);
  }
  EXPECT_TRUE(says(report(result), {"open", "t = 1."}));
}

TEST(Outcome, AContactThatClosesAgainHasNotOpened) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe,
      {"supports.3.displacement.z={t=[0, 1, 2, 4], values=[-0.025, 0.01, 0.01, -0.05]}", "time.output=[1.5]"});
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  const SummaryFile summary(blocks / "out/summary.json");
  EXPECT_FALSE(summary.has(contact + "opened"));
  EXPECT_GT(summary.number(contact + "final_normal_force"), 2);
}

}  // namespace
}  // namespace outcome_tests
}  // namespace creepcontact::run::test
