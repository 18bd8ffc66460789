/// Runs in cycles: the blocks are pressed and held while their temperature goes up and down. The creep rate follows the
/// temperature, so that the pressure is relaxed_pressure() of the time at 100 degrees that all cycles are worth.

#include <cmath>
#include <csignal>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Cycles of 1: hot for 0.5, half of the rate on the ramps of 0.1, cold for 0.3. A cycle is worth 0.6 `rate`.
std::string hot_and_cold(double rate = 1) {
  return pressure_probe + "[temperature]\nvalue = { t = [0, 0.1, 0.6, 0.7], values = [0, " + std::to_string(rate) +
         ", " + std::to_string(rate) + ", 0], period = 1 }\n";
}

std::vector<std::string> in_cycles(std::vector<std::string> more) {
  more.insert(more.end(), {"materials.soft.creep.0.A='1e-3*T'", "materials.hard.creep.0.A='1e-3*T'", "time.cycle=1",
                           "output.fields=false"});
  return more;
}

SummaryFile summary_of_cycles(const config::Config& config, const std::filesystem::path& out, bool resume = false) {
  const Summary result = run(config, {.output = out.string(), .resume = resume});
  EXPECT_EQ(result.exit_status, 0) << result.message;
  return SummaryFile(out / "summary.json");
}

TEST(Cycles, AreReportedOneByOne) {
  const Case blocks;
  const config::Config config =
      blocks.config(hot_and_cold(), in_cycles({"time.end=5.5", "time.output=[2]", "time.tolerance=1e-6"}));
  const SummaryFile summary = summary_of_cycles(config, blocks / "out");
  EXPECT_EQ(summary.number("cycles/completed"), 5);
  EXPECT_EQ(summary.number("cycles/computed"), 5);
  const Table cycles(blocks / "out" / "cycles.csv");
  EXPECT_EQ(cycles.times(), (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_EQ(cycles.column("cycle"), cycles.times());
  for (int k = 1; k <= 5; ++k) {
    const double before = relaxed_pressure(0.6 * (k - 1)), after = relaxed_pressure(0.6 * k);
    EXPECT_NEAR(cycles.at("pressure_max", k), before, 1e-5);
    EXPECT_NEAR(cycles.at("pressure_min", k), after, 1e-5);
    EXPECT_NEAR(cycles.at("pressure_end", k), after, 1e-5);
    // The pressure is uniform and uniaxial: the elastic strain becomes creep strain, of the soft block twice as much.
    const double change = (before - after) / 1;  // strain of both: (2/100 + 1/200) stress, (2 + 1) creep
    EXPECT_NEAR(cycles.at("lower.inelastic_strain_range", k), 0.025 / 3 * change, 1e-6);
    EXPECT_NEAR(cycles.at("upper.inelastic_strain_range", k), 0.025 / 3 * change, 1e-6);
    EXPECT_NEAR(cycles.at("stress_change", k), change / before, 1e-4);
    EXPECT_GT(cycles.at("elastic_solves", k), 5);
    EXPECT_EQ(cycles.at("jumped", k), 0);
  }
  const Table history(blocks / "out" / "history.csv");
  EXPECT_NEAR(history.at("pressure", 2), relaxed_pressure(1.2), 1e-5);
  EXPECT_NEAR(history.at("pressure", 5.5), relaxed_pressure(0.6 * 5 + 0.45), 1e-5);
}

/// A probe whose extremes lie between the breakpoints of the cycle.
TEST(Cycles, HaveTheExtremesOfAllSteps) {
  const Case blocks;
  const std::string hump = "[[probes]]\nname = \"hump\"\nexpression = \"(t - floor(t))*(1 - t + floor(t))\"\n";
  const config::Config config =
      blocks.config(hot_and_cold() + hump,
                    in_cycles({"time.end=2", "time.output=[]", "time.integrator=explicit_euler", "time.step=0.02"}));
  summary_of_cycles(config, blocks / "out");
  const Table cycles(blocks / "out" / "cycles.csv");
  for (const double k : {1.0, 2.0}) EXPECT_NEAR(cycles.at("hump_max", k), 0.25, 5e-4);
}

TEST(Cycles, ASteadyOneEndsTheRun) {
  const Case blocks;
  const config::Config config =
      blocks.config(hot_and_cold(), in_cycles({"time.end=500", "time.stop_when_steady=1e-2", "time.tolerance=1e-5"}));
  const SummaryFile summary = summary_of_cycles(config, blocks / "out");
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_TRUE(says(summary.text("message"), {"cycle ", "t = ", "0.01"}));
  const double last = summary.number("cycles/steady");
  EXPECT_EQ(summary.number("time_reached"), last);
  EXPECT_EQ(Table(blocks / "out" / "history.csv").times().back(), last);
  const Table cycles(blocks / "out" / "cycles.csv");
  EXPECT_EQ(cycles.rows(), last);
  EXPECT_LT(cycles.at("stress_change", last), 1e-2);
  // A change of 1 % by a cycle: 0.36*0.6/3 p^3 = 0.01
  EXPECT_NEAR(std::pow(relaxed_pressure(0.6 * last), 3) * 0.072, 1e-2, 1e-3);
  // The same condition leaves nothing to do, a stricter one does.
  const Summary again = run(config, {.output = (blocks / "out").string(), .resume = true});
  EXPECT_TRUE(says(again.message, {"cycle ", "time.stop_when_steady"}));
  const config::Config stricter =
      blocks.config(hot_and_cold(), in_cycles({"time.end=500", "time.stop_when_steady=8e-3", "time.tolerance=1e-5"}));
  const SummaryFile later = summary_of_cycles(stricter, blocks / "out", true);
  EXPECT_GT(later.number("cycles/steady"), last);
  EXPECT_EQ(Table(blocks / "out" / "cycles.csv").rows(), later.number("cycles/steady"));
}

const std::vector<std::string> integrators{"auto", "log_adams", "cvode_bdf", "arkode_erk", "beta_euler"};

class CycleJumps : public testing::TestWithParam<std::string> {};

TEST_P(CycleJumps, ReachTheEndOfAThousandCyclesInFew) {
  const Case blocks;
  const config::Config config =
      blocks.config(hot_and_cold(), in_cycles({"time.end=1000", "time.output=[100, 100.3]", "time.jump_cycles=true",
                                               "time.integrator=" + GetParam(), "time.step=adaptive"}));
  const SummaryFile summary = summary_of_cycles(config, blocks / "out");
  EXPECT_EQ(summary.number("cycles/completed"), 1000);
  EXPECT_LT(summary.number("cycles/computed"), 100);
  EXPECT_GT(summary.number("cycles/longest_jump"), 30);
  const Table history(blocks / "out" / "history.csv");
  EXPECT_EQ(history.times(), (std::vector<double>{0, 100, 100.3, 1000}));
  for (const auto& [t, hot] : std::vector<std::pair<double, double>>{{100, 60}, {100.3, 60.25}, {1000, 600}})
    EXPECT_NEAR(history.at("pressure", t), relaxed_pressure(hot), 5e-3 * relaxed_pressure(hot)) << t;
  const Table cycles(blocks / "out" / "cycles.csv");
  EXPECT_EQ(static_cast<double>(cycles.rows()) + summary.number("cycles/rejected_jumps"),
            summary.number("cycles/computed"));
  EXPECT_EQ(cycles.sum("jumped") + static_cast<double>(cycles.rows()), 1000);
  double before = 0;
  const Table steps(blocks / "out" / "steps.csv");
  for (const double t : steps.times()) {
    EXPECT_GT(t, before) << "steps of rejected jumps are no results";
    before = t;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, CycleJumps, testing::ValuesIn(integrators),
                         [](const auto& tested) { return tested.param; });

/// Begins a run and interrupts it, as Ctrl-C does, after so many steps.
class InterruptAfter final : public Observer {
 public:
  explicit InterruptAfter(int steps) : left_(steps) {}
  Reaction step(StepView& /*view*/) override {
    if (--left_ == 0) std::raise(SIGINT);
    return Reaction::advance;
  }

 private:
  int left_;
};

class CycleResume : public testing::TestWithParam<std::string> {};

TEST_P(CycleResume, RepeatsTheBitsWhereverItWasInterrupted) {
  const Case blocks;
  const config::Config config =
      blocks.config(hot_and_cold(), in_cycles({"time.end=60", "time.output=[8, 30]", "time.jump_cycles=true",
                                               "time.integrator=" + GetParam(), "output.checkpoint_seconds=0"}));
  const std::filesystem::path whole = blocks / "whole", parts = blocks / "parts";
  const SummaryFile expected = summary_of_cycles(config, whole);
  EXPECT_GT(expected.number("cycles/jumps"), 3);
  bool resume = false;
  for (const int steps : {7, 40, 31, 90, 55}) {
    InterruptAfter observer(steps);
    const Summary result = run(config, {.output = parts.string(), .resume = resume, .observers = {&observer}});
    if (result.exit_status == 0) break;
    ASSERT_EQ(result.exit_status, 130) << result.message;
    resume = true;
  }
  const SummaryFile found = summary_of_cycles(config, parts, true);
  for (const char* file : {"history.csv", "steps.csv"})
    EXPECT_EQ(read_text(parts / file), read_text(whole / file)) << file;
  const Table cycles(parts / "cycles.csv"), all(whole / "cycles.csv");
  for (const std::string& name : all.names()) {
    if (name == "elastic_solves" || name == "steps") continue;  // of an interrupted cycle they count twice
    EXPECT_EQ(cycles.column(name), all.column(name)) << name;
  }
  for (const char* key : {"cycles/completed", "cycles/computed", "cycles/jumps", "cycles/rejected_jumps"})
    EXPECT_EQ(found.number(key), expected.number(key)) << key;
}

INSTANTIATE_TEST_SUITE_P(Integrators, CycleResume, testing::Values("auto", "log_adams"),
                         [](const auto& tested) { return tested.param; });

TEST(Cycles, ALongerRunGoesOnFromTheMiddleOfOne) {
  const Case blocks;
  const std::filesystem::path out = blocks / "out";
  summary_of_cycles(blocks.config(hot_and_cold(), in_cycles({"time.end=2.5", "time.tolerance=1e-6"})), out);
  const SummaryFile summary =
      summary_of_cycles(blocks.config(hot_and_cold(), in_cycles({"time.end=5", "time.tolerance=1e-6"})), out, true);
  EXPECT_EQ(summary.number("cycles/completed"), 5);
  const Table cycles(out / "cycles.csv");
  EXPECT_EQ(cycles.times(), (std::vector<double>{1, 2, 4, 5})) << "the third was not seen from its begin";
  EXPECT_NEAR(cycles.at("pressure_end", 5), relaxed_pressure(3), 1e-5);
}

TEST(JumpsOverCycles, DoNotPassOverAnEvent) {
  const Case blocks;
  const std::string leak = hot_and_cold() + "[[events]]\nname = 'leak'\nwhen = 'pressure < 0.3'\nstop = true\n";
  const config::Config config =
      blocks.config(leak, in_cycles({"time.end=1000", "time.jump_cycles=true", "time.tolerance=1e-5"}));
  const SummaryFile summary = summary_of_cycles(config, blocks / "out");
  // p^-3 = 1 + 0.36 t of hot time
  const double hot = (std::pow(0.3, -3) - 1) / 0.36, cycles = std::floor(hot / 0.6);
  const double rest = hot - 0.6 * cycles, expected = cycles + (rest < 0.05 ? std::sqrt(0.2 * rest) : rest + 0.05);
  EXPECT_NEAR(summary.number("events/leak"), expected, 0.3);
  EXPECT_LT(summary.number("cycles/computed"), 70);
}

TEST(JumpsOverCycles, EndWhereTheLoadsChange) {
  const Case blocks;
  // From cycle 300 on everything is twice as hot.
  const std::string temperature = pressure_probe +
                                  "[temperature]\nvalue = '(1 + (t > 300))*max(0, min(min(1, mod(t, 1)/0.1), "
                                  "(0.7 - mod(t, 1))/0.1))'\n";
  const config::Config config =
      blocks.config(temperature, in_cycles({"time.end=600", "time.jump_cycles=true", "time.breakpoints=[300]"}));
  const SummaryFile summary = summary_of_cycles(config, blocks / "out");
  const double expected = relaxed_pressure(0.6 * (300 + 2 * 300));
  EXPECT_NEAR(Table(blocks / "out" / "history.csv").at("pressure", 600), expected, 5e-3 * expected);
  const Table cycles(blocks / "out" / "cycles.csv");
  EXPECT_NO_THROW(cycles.at("cycle", 300)) << "computed, as the last one of its kind";
  for (const double t : {301.0, 302.0, 303.0}) EXPECT_EQ(cycles.at("jumped", t), 0) << t;
  EXPECT_LT(summary.number("cycles/computed"), 150);
}

/// With fatigue data: strain ranges, their damage, and what it makes of the run.
TEST(CreepFatigue, CountsCyclesAtEveryPoint) {
  const Case blocks;
  // The top moves to and fro; cold, so that nothing creeps: the strain range is elastic, stress/E of each block.
  const std::string fatigue = pressure_probe + R"(
[[probes]]
name = "used"
quantity = "fatigue_fraction"
body = "lower"
reduce = "max"
[materials.soft.fatigue]
cycles_to_failure = "1/eps"
interaction = [[0.3, 0.3]]
)";
  const config::Config config =
      blocks.config(fatigue, {"time.cycle=1", "time.end=30", "time.output=[10]", "materials.soft.creep.0.A=1e-12",
                              "materials.hard.creep.0.A=1e-12", "output.fields=false",
                              "supports.3.displacement.z={t=[0,0.5,1],values=[-0.025,-0.0125,-0.025],period=1}"});
  const SummaryFile summary = summary_of_cycles(config, blocks / "out");
  // A uniaxial stress range of 0.5: the equivalent strain is 2/3 (1 + nu) of the axial one.
  const double range = 2.0 / 3 * 1.3 * 0.5 / 100;
  const Table cycles(blocks / "out" / "cycles.csv");
  for (const double t : {1.0, 17.0, 30.0}) {
    EXPECT_NEAR(cycles.at("lower.strain_range", t), range, 1e-6);
    EXPECT_NEAR(cycles.at("upper.strain_range", t), range / 2, 1e-6);
    EXPECT_NEAR(cycles.at("lower.fatigue_fraction_per_cycle", t), range, 1e-6);
    EXPECT_NEAR(cycles.at("lower.fatigue_fraction", t), range * t, 1e-5);
    EXPECT_NEAR(cycles.at("lower.creep_fatigue", t), range * t, 1e-5);
    EXPECT_NEAR(cycles.at("lower.cycles_to_limit", t), 1 / range, 1e-2);
  }
  EXPECT_NEAR(Table(blocks / "out" / "history.csv").at("used", 10), 10 * range, 1e-5);
  EXPECT_NEAR(summary.number("fatigue_fraction/lower/largest"), 30 * range, 1e-5);
  EXPECT_NEAR(summary.number("creep_fatigue/lower/largest"), 30 * range, 1e-5);
  EXPECT_NEAR(summary.number("cycles/to_limit/lower"), 1 / range, 1e-2);
  EXPECT_FALSE(summary.has("creep_fatigue/upper"));
}

TEST(CreepFatigue, IsExtrapolatedInJumps) {
  const Case blocks;
  const std::string life = hot_and_cold() +
                           "[materials.soft.rupture]\nrupture_time = '2e3/q'\n[materials.soft.fatigue]\n"
                           "strain_range = [1e-5, 1e-2]\ncycles = [1e8, 100]\ninteraction = [[0.3, 0.3]]\n";
  const auto usage = [&](bool jump, const char* directory) {
    const config::Config config =
        blocks.config(life, in_cycles({"time.end=400", jump ? "time.jump_cycles=true" : "time.jump_cycles=false"}));
    return summary_of_cycles(config, blocks / directory);
  };
  const SummaryFile full = usage(false, "full"), jumped = usage(true, "jumped");
  EXPECT_LT(jumped.number("cycles/computed"), 80);
  for (const char* key : {"life_fraction/lower/largest", "creep_fatigue/lower/largest"})
    EXPECT_NEAR(jumped.number(key), full.number(key), 5e-3 * full.number(key)) << key;
  EXPECT_LT(jumped.number("elastic_solves"), 0.25 * full.number("elastic_solves"));
}

}  // namespace
}  // namespace creepcontact::run::test
