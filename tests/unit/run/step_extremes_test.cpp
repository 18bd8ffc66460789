/// Extremes between output times: the summary takes them from the ends of the steps and from the breakpoints.

#include <csignal>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace step_extremes_tests {
namespace {

const std::string contact = "contacts/lower_top-upper_bottom/";
/// Pressed twice as hard for a moment, at t = 1, where nothing is written.
const std::string peak =
    "supports.3.displacement.z={t=[0, 0.9, 1, 1.1, 4], values=[-0.0125, -0.0125, -0.025, -0.0125, "
    "-0.0125]}";
/// The same with jumps.
const std::string pulse = "supports.3.displacement.z=t >= 1 && t < 1.2 ? -0.025 : -0.0125";

SummaryFile summary_of(const Case& blocks, const std::vector<std::string>& overrides, std::string* report = nullptr) {
  const Summary result = run(blocks.config(pressure_probe, overrides), {.output = (blocks / "out").string()});
  EXPECT_EQ(result.exit_status, 0) << result.message;
  if (report != nullptr) *report = run::report(result);
  return SummaryFile(blocks / "out/summary.json");
}

class StepExtremes : public testing::TestWithParam<std::string> {};

/// Hardly anything creeps: the pressure follows the displacement.
TEST_P(StepExtremes, OfAPeakBetweenOutputs) {
  for (const std::string& load : {peak, pulse}) {
    const Case blocks;
    const SummaryFile summary =
        summary_of(blocks, {load, "time.output=[3]", "materials.soft.creep.0.A=1e-7", "materials.hard.creep.0.A=1e-7",
                            "time.integrator=" + GetParam(), "time.step=0.1"});
    EXPECT_NEAR(summary.number(contact + "initial_normal_force"), 1, 1e-3) << load;
    EXPECT_NEAR(summary.number(contact + "largest_normal_force"), 2, 1e-3) << load;
    EXPECT_NEAR(summary.number(contact + "t_largest_normal_force"), 1, 0.2 + 1e-9) << load;
    EXPECT_NEAR(summary.number(contact + "final_normal_force"), 1, 1e-3) << load;
    EXPECT_NEAR(summary.number("probes/pressure/max"), 1, 1e-3) << load;
    EXPECT_NEAR(summary.number("probes/pressure/t_max"), 1, 0.2 + 1e-9) << load;
    EXPECT_NEAR(summary.number("bodies/lower/largest_von_mises"), 1, 1e-3) << load;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, StepExtremes,
                         testing::Values("auto", "log_adams", "cvode_bdf", "cvode_adams", "arkode_erk", "arkode_dirk",
                                         "beta_euler", "explicit_euler"),
                         [](const auto& of) { return of.param; });

TEST(StepExtremes, OfElasticBodies) {
  for (const std::string& load : {peak, pulse})
    for (const char* friction : {"0", "0.3"}) {
      const Case blocks;
      const SummaryFile summary =
          summary_of(blocks, elastic({load, "time.output=[3]", std::string("contacts.0.friction=") + friction}));
      // Friction holds back the unlike widening of the blocks, which makes them stiffer.
      const Case written;
      summary_of(written, elastic({load, "time.output=[1]", std::string("contacts.0.friction=") + friction}));
      const double pressure = Table(written / "out/history.csv").at("pressure", 1);
      EXPECT_NEAR(pressure, 1, 0.01);
      EXPECT_NEAR(summary.number(contact + "largest_normal_force"), 2 * pressure, 1e-6) << load << friction;
      EXPECT_EQ(summary.number(contact + "t_largest_normal_force"), 1) << load << friction;
      EXPECT_NEAR(summary.number("probes/pressure/max"), pressure, 1e-6) << load << friction;
    }
}

/// The values at output times are what they were, and no state of a step comes between them and the extremes.
TEST(StepExtremes, AreThoseOfTheOutputsWhereNothingExceedsThem) {
  const Case blocks;
  const SummaryFile summary = summary_of(blocks, {"time.output=[1, 2]"});
  for (const char* name : {"min", "end"})
    EXPECT_EQ(summary.number(std::string("probes/pressure/") + name),
              Table(blocks / "out/history.csv").at("pressure", 4));
  EXPECT_EQ(summary.number("probes/pressure/max"), summary.number("probes/pressure/start"));
  EXPECT_EQ(summary.number("probes/pressure/t_min"), 4);
  EXPECT_EQ(summary.number("last_output"), 4);
}

/// Pressed in the middle of each cycle, lifted at its ends, where the outputs are.
const std::string cycles = "supports.3.displacement.z={t=[0, 0.5, 1], values=[0.01, -0.025, 0.01], period=1}";

TEST(StepExtremes, OfCyclesThatEndUnloaded) {
  const Case blocks;
  std::string report;
  const SummaryFile summary = summary_of(blocks,
                                         {cycles, "time.cycle=1", "time.end=6", "time.output=[2, 4]",
                                          "materials.soft.creep.0.A=1e-5", "materials.hard.creep.0.A=1e-5"},
                                         &report);
  const Table rows(blocks / "out/cycles.csv");
  double largest = 0;
  for (const double pressure : rows.column("pressure_max")) largest = std::max(largest, pressure);
  ASSERT_GT(largest, 0.99);
  EXPECT_NEAR(summary.number("probes/pressure/max"), largest, 2e-4);
  EXPECT_NEAR(summary.number(contact + "largest_normal_force"), 2 * largest, 4e-4);
  EXPECT_EQ(summary.number(contact + "final_normal_force"), 0);
  EXPECT_EQ(summary.number(contact + "openings"), 6);
  EXPECT_FALSE(summary.has(contact + "opened")) << "the next cycle closes it";
  EXPECT_TRUE(says(report, {"contact 'lower_top-upper_bottom'", "opens", "every cycle"}));
}

TEST(StepExtremes, WithoutCyclesAContactThatOpensAgainIsOpenFromTheLastTimeOn) {
  const Case blocks;
  std::string report;
  const SummaryFile summary = summary_of(blocks, {cycles, "time.end=3.1", "time.output=[2]"}, &report);
  EXPECT_EQ(summary.number(contact + "openings"), 3);
  EXPECT_GT(summary.number(contact + "opened"), 2.5);
  EXPECT_LE(summary.number(contact + "opened"), 3);
  EXPECT_TRUE(says(report, {"open", "t = ", "3 times"}));
}

/// Jumps over cycles leave the extremes of those that are computed; rejected ones leave nothing.
TEST(StepExtremes, OfCyclesThatAreJumpedOver) {
  const Case blocks;
  const std::vector<std::string> all{cycles, "time.cycle=1", "time.end=40", "materials.soft.creep.0.A=1e-4",
                                     "materials.hard.creep.0.A=1e-4"};
  std::vector<std::string> jumping = all;
  jumping.emplace_back("time.jump_cycles=true");
  const SummaryFile summary = summary_of(blocks, jumping);
  const Case plain;
  const SummaryFile expected = summary_of(plain, all);
  EXPECT_GT(summary.number("cycles/jumps"), 0);
  EXPECT_NEAR(summary.number("probes/pressure/max"), expected.number("probes/pressure/max"), 1e-3);
  EXPECT_NEAR(summary.number(contact + "largest_normal_force"), expected.number(contact + "largest_normal_force"),
              2e-3);
}

TEST(StepExtremes, OfAResumedRunAreThoseOfTheWholeOne) {
  const Case blocks;
  for (const char* integrator : {"cvode_adams", "log_adams"}) {
    const config::Config config =
        blocks.config(pressure_probe, {peak, "time.output=[0.5, 2, 3]", std::string("time.integrator=") + integrator});
    const std::filesystem::path whole = blocks / "whole", parts = blocks / "parts";
    ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);
    InterruptAtOutput interrupt(3);  // at t = 2, after the peak
    ASSERT_EQ(run(config, {.output = parts.string(), .observers = {&interrupt}}).exit_status, 130);
    ASSERT_EQ(run(config, {.output = parts.string(), .resume = true}).exit_status, 0);
    const SummaryFile expected(whole / "summary.json"), found(parts / "summary.json");
    for (const std::string& key :
         {contact + "largest_normal_force", contact + "t_largest_normal_force", std::string("probes/pressure/max"),
          std::string("probes/pressure/t_max"), std::string("bodies/upper/largest_von_mises")})
      EXPECT_EQ(found.number(key), expected.number(key)) << key << " with " << integrator;
    EXPECT_GT(found.number(contact + "largest_normal_force"), 1.5);
  }
}

/// The top is held where it is: rounding alone makes forces.
TEST(StepExtremes, RoundingIsNoForce) {
  const Case blocks;
  std::string report;
  const SummaryFile summary = summary_of(blocks, {"supports.3.displacement.z=1e-19*t"}, &report);
  for (const char* name : {"initial", "largest", "final"}) {
    EXPECT_EQ(summary.number(contact + name + "_normal_force"), 0);
    EXPECT_EQ(summary.number(std::string("bodies/lower/") + name + "_von_mises"), 0);
  }
  EXPECT_FALSE(summary.has(contact + "opened"));
  EXPECT_TRUE(says(report, {"contact 'lower_top-upper_bottom'", "no force"}));
  EXPECT_FALSE(contains(report, "%")) << report;
}

TEST(StepExtremes, AnInterruptedRunNamesTheTimeOfItsLastValues) {
  const Case blocks;
  const config::Config config =
      blocks.config(pressure_probe, {"time.output=[1]", "time.integrator=log_adams", "time.end=400"});
  struct Interrupting final : Observer {
    Reaction step(StepView& view) override {
      if (view.time() > 2) std::raise(SIGINT);
      return Reaction::advance;
    }
  } observer;
  const Summary result = run(config, {.output = (blocks / "out").string(), .observers = {&observer}});
  EXPECT_TRUE(says(result.message, {"t = 1;"}));
  EXPECT_TRUE(says(report(result), {"last output", "t = 1 "}));
  const SummaryFile summary(blocks / "out/summary.json");
  EXPECT_EQ(summary.number("last_output"), 1);
  EXPECT_GT(summary.number("time_reached"), 2);
}

}  // namespace
}  // namespace step_extremes_tests
}  // namespace creepcontact::run::test
