#include <csignal>

#include "../../../src/simulation/time_loop.hpp"
#include "creepcontact/base/error.hpp"
#include "running.hpp"

namespace creepcontact::simulation::test {
namespace {

/// Begins a run and interrupts it, as Ctrl-C does, right after an output time. @returns the time it reached
double interrupted_run(const config::Config& config, const std::filesystem::path& directory, int outputs) {
  System system(config);
  TimeLoop loop(config, system.rate, system.watch, directory, false, true);
  loop.after_output = [&] {
    if (--outputs == 0) std::raise(SIGINT);
  };
  EXPECT_EQ(loop.run(), TimeLoop::End::interrupted);
  EXPECT_TRUE(std::filesystem::exists(directory / "checkpoint.h5"));
  return loop.time();
}

struct ResumeCase {
  const char* name;
  double tolerance;  ///< of the history against that of an uninterrupted run; 0: the same to the last bit
  std::vector<std::string> overrides;
};

class Resume : public testing::TestWithParam<ResumeCase> {};

TEST_P(Resume, EndsAsTheUninterruptedRun) {
  const Case blocks;
  std::vector<std::string> overrides = GetParam().overrides;
  overrides.emplace_back("time.output=[0.5, 1, 1.6, 3]");
  const config::Config config = blocks.config(pressure_probe, overrides);
  const std::filesystem::path whole = blocks / "whole", parts = blocks / "parts";
  ASSERT_EQ(run(config, {.output = whole.string(), .quiet = true}).exit_status, 0);

  const double reached = interrupted_run(config, parts, 3);  // at 0, 0.5, 1
  EXPECT_GE(reached, 0.5);
  EXPECT_LT(reached, 4);
  const std::string begin = read_text(parts / "history.csv");
  const RunResult result = run(config, {.output = parts.string(), .resume = true, .quiet = true});
  ASSERT_EQ(result.exit_status, 0) << result.message;
  const std::string resumed = read_text(parts / "history.csv");
  EXPECT_EQ(resumed.substr(0, begin.size()), begin);

  const Csv expected(whole / "history.csv"), found(parts / "history.csv");
  EXPECT_EQ(found.column("time"), expected.column("time"));
  for (std::size_t i = 0; i < std::min(found.rows.size(), expected.rows.size()); ++i)
    EXPECT_NEAR(found.rows[i][1], expected.rows[i][1], GetParam().tolerance) << "row " << i;
  if (GetParam().tolerance == 0) {
    EXPECT_EQ(resumed, read_text(whole / "history.csv"));
    EXPECT_EQ(Csv(parts / "steps.csv").column("time"), Csv(whole / "steps.csv").column("time"));
  }
  // The costs of both parts are in the summary.
  const std::string summary = read_text(parts / "summary.json");
  EXPECT_TRUE(contains(summary, "\"status\": \"completed\"")) << summary;
  EXPECT_EQ(number_in(summary, "steps"), static_cast<double>(Csv(parts / "steps.csv").rows.size()));
  EXPECT_EQ(number_in(summary, "factorizations"), 4);
  // A field file an output time, none twice.
  const std::string fields = read_text(parts / "fields.pvd");
  EXPECT_EQ(fields, read_text(whole / "fields.pvd"));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Resume,
    testing::Values(ResumeCase{"explicit_euler",
                               0,
                               {"time.integrator=explicit_euler", "time.step=0.25",
                                "contact_solver.method=active_set"}},
                    ResumeCase{"explicit_euler_odd_step",
                               1e-13,
                               {"time.integrator=explicit_euler", "time.step=0.1", "contact_solver.method=active_set"}},
                    ResumeCase{"explicit_euler_schwarz", 1e-9, {"time.integrator=explicit_euler", "time.step=0.25"}},
                    ResumeCase{"explicit_euler_stable", 1e-9, {"time.integrator=explicit_euler"}},
                    ResumeCase{"beta_euler", 1e-8, {"time.integrator=beta_euler", "time.step=0.25"}},
                    ResumeCase{"cvode_bdf", 5e-4, {}}, ResumeCase{"arkode_dirk", 5e-4, {"time.integrator=arkode_dirk"}},
                    ResumeCase{"with_breakpoints", 5e-4, {"time.breakpoints=[0.75, 1, 2]"}},
                    ResumeCase{"elastic",
                               0,
                               {"materials.soft.creep=[]", "materials.hard.creep=[]",
                                "supports.3.displacement.z=-0.01*(1+t)", "contact_solver.method=active_set"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(ResumeAtOnce, FromAnInterruptionBeforeTheFirstStep) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, {"time.output=[1]"});
  EXPECT_EQ(interrupted_run(config, blocks / "out", 1), 0);
  EXPECT_EQ(Csv(blocks / "out/history.csv").column("time"), std::vector<double>{0});
  ASSERT_EQ(run(config, {.output = (blocks / "out").string(), .resume = true, .quiet = true}).exit_status, 0);
  EXPECT_EQ(Csv(blocks / "out/history.csv").column("time"), (std::vector<double>{0, 1, 4}));
}

TEST(ResumeMistakes, CheckpointOfAnotherModel) {
  const Case blocks;
  const std::filesystem::path out = blocks / "out";
  interrupted_run(blocks.config(pressure_probe), out, 1);
  const std::string history = read_text(out / "history.csv"), checkpoint = read_text(out / "checkpoint.h5");
  for (const char* other : {"materials.soft.young_modulus=101", "materials.hard.creep.0.n=5", "mesh.order=2",
                            "bodies.upper.material=soft"}) {
    const config::Config config = blocks.config(pressure_probe, {other});
    const std::string message =
        message_of<ConfigError>([&] { run(config, {.output = out.string(), .resume = true, .quiet = true}); });
    EXPECT_TRUE(contains(message, (out / "checkpoint.h5").string() + ": the checkpoint is of another model"))
        << other << ": " << message;
  }
  EXPECT_EQ(read_text(out / "history.csv"), history);
  EXPECT_EQ(read_text(out / "checkpoint.h5"), checkpoint);
}

TEST(ResumeMistakes, NoCheckpoint) {
  const Case blocks;
  const std::string message = message_of<ConfigError>(
      [&] { run(blocks.config(), {.output = (blocks / "out").string(), .resume = true, .quiet = true}); });
  EXPECT_TRUE(contains(message, "checkpoint.h5")) << message;
}

TEST(ResumeMistakes, OtherProbes) {
  const Case blocks;
  const std::filesystem::path out = blocks / "out";
  interrupted_run(blocks.config(pressure_probe), out, 1);
  const std::string message =
      message_of<ConfigError>([&] { run(blocks.config(), {.output = out.string(), .resume = true, .quiet = true}); });
  EXPECT_TRUE(contains(message, "other columns")) << message;
}

volatile std::sig_atomic_t signals_of_the_caller = 0;

TEST(Interrupts, HandlersOfTheCallerComeBack) {
  const Case blocks;
  const auto before = std::signal(SIGINT, [](int) { signals_of_the_caller = signals_of_the_caller + 1; });
  interrupted_run(blocks.config(pressure_probe), blocks / "out", 1);
  EXPECT_EQ(signals_of_the_caller, 0);
  std::raise(SIGINT);
  EXPECT_EQ(signals_of_the_caller, 1);
  std::signal(SIGINT, before);
}

}  // namespace
}  // namespace creepcontact::simulation::test
