#include <csignal>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Begins a run and interrupts it, as Ctrl-C does, right after an output time. @returns the time it reached
double interrupted_run(const config::Config& config, const std::filesystem::path& directory, int outputs,
                       bool resume = false) {
  InterruptAtOutput interrupt(outputs);
  const Summary summary = run(config, {.output = directory.string(), .resume = resume, .observers = {&interrupt}});
  EXPECT_EQ(summary.exit_status, 130);
  EXPECT_TRUE(std::filesystem::exists(directory / "checkpoint.h5"));
  return summary.results.time_reached;
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
  ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);

  const double reached = interrupted_run(config, parts, 3);  // at 0, 0.5, 1
  EXPECT_GE(reached, 0.5);
  EXPECT_LT(reached, 4);
  const std::string begin = read_text(parts / "history.csv");
  const Summary result = run(config, {.output = parts.string(), .resume = true});
  ASSERT_EQ(result.exit_status, 0) << result.message;
  const std::string resumed = read_text(parts / "history.csv");
  EXPECT_EQ(resumed.substr(0, begin.size()), begin);

  const Table expected(whole / "history.csv"), found(parts / "history.csv");
  EXPECT_EQ(found.times(), expected.times());
  for (const double t : expected.times())
    EXPECT_NEAR(found.at("pressure", t), expected.at("pressure", t), GetParam().tolerance) << t;
  if (GetParam().tolerance == 0) {
    EXPECT_EQ(resumed, read_text(whole / "history.csv"));
    EXPECT_EQ(read_text(parts / "steps.csv"), read_text(whole / "steps.csv"));
  }
  // The costs of both parts are in the summary.
  const SummaryFile summary(parts / "summary.json");
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_EQ(summary.number("steps"), Table(parts / "steps.csv").rows());
  EXPECT_EQ(summary.number("factorizations"), 4);
  // One field file per output time.
  for (const char* file : {"fields.pvd", "contact.pvd"}) EXPECT_EQ(read_text(parts / file), read_text(whole / file));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Resume,
    testing::Values(
        ResumeCase{"explicit_euler", 0, {"time.integrator=explicit_euler", "time.step=0.25"}},
        ResumeCase{"explicit_euler_odd_step",
                   0,
                   {"time.integrator=explicit_euler", "time.step=0.1", "contact_solver.method=active_set"}},
        ResumeCase{"explicit_euler_stable", 0, {"time.integrator=explicit_euler", "time.step_factor=0.1"}},
        ResumeCase{"beta_euler", 0, {"time.integrator=beta_euler", "time.step=0.125", "time.inner_tolerance=1e-7"}},
        ResumeCase{"beta_euler_stable", 0, {"time.integrator=beta_euler", "time.step_factor=0.2", "time.beta=0.5"}},
        ResumeCase{
            "beta_euler_anderson",
            0,
            {"time.integrator=beta_euler", "time.step=0.3", "time.inner_anderson=3", "time.residual_correction=0.5"}},
        ResumeCase{"chaboche",
                   0,
                   {"materials.soft.creep=[{law='chaboche', K=0.4, n=5, yield=0.3, Q=0.1, b=40, C=[40], gamma=[150], "
                    "recovery=[0.2]}]"}},
        ResumeCase{"beta_euler_newton", 0, {"time.integrator=beta_euler", "time.step=0.3", "time.inner=newton"}},
        ResumeCase{"euler_adaptive", 0, {"time.integrator=explicit_euler", "time.step=adaptive"}},
        ResumeCase{"auto", 5e-4, {"time.integrator=auto"}},
        ResumeCase{"arkode_erk", 0, {"time.integrator=arkode_erk", "time.tolerance=1e-8"}},
        ResumeCase{"arkode_dirk", 0, {"time.integrator=arkode_dirk", "time.tolerance=1e-8"}},
        ResumeCase{"arkode_with_breakpoints", 0, {"time.integrator=arkode_dirk", "time.breakpoints=[0.75, 1, 2]"}},
        ResumeCase{"contact_that_opens",
                   0,
                   {"time.integrator=arkode_erk", "time.tolerance=1e-6", "contacts.0.gap='0.02*x*sin(t)-0.01'"}},
        ResumeCase{"failing_sweeps",
                   0,
                   {"time.integrator=arkode_erk", "contact_solver.acceleration=none", "contact_solver.alpha=1.0",
                    "contact_solver.max_iterations=20"}},
        ResumeCase{"cvode_bdf", 5e-4, {}}, ResumeCase{"cvode_adams", 5e-4, {"time.integrator=cvode_adams"}},
        ResumeCase{"log_adams", 5e-4, {"time.integrator=log_adams"}},
        ResumeCase{"cvode_with_breakpoints", 5e-4, {"time.breakpoints=[0.75, 1, 2]"}},
        ResumeCase{"elastic", 0,
                   elastic({"supports.3.displacement.z=-0.01*(1+t)", "contacts.0.gap='0.02*x*sin(t)-0.01'"})}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// Steps too are the same, with their costs: nothing but the wall time tells the resumed run from the other.
TEST(ResumeTwice, LeavesTheStepsOfTheUninterruptedRun) {
  const Case blocks;
  const config::Config config =
      blocks.config(pressure_probe, {"time.integrator=arkode_dirk", "time.tolerance=1e-8", "time.breakpoints=[1.2]",
                                     "time.output=[0.5, 1, 1.6, 3]", "output.checkpoint_seconds=0"});
  const std::filesystem::path whole = blocks / "whole", parts = blocks / "parts";
  ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);
  interrupted_run(config, parts, 2);
  for (int more : {1, 2}) interrupted_run(config, parts, more, true);
  ASSERT_EQ(run(config, {.output = parts.string(), .resume = true}).exit_status, 0);
  for (const char* file : {"history.csv", "steps.csv", "fields.pvd"})
    EXPECT_EQ(read_text(parts / file), read_text(whole / file)) << file;
  EXPECT_GT(Table(whole / "steps.csv").rows(), 60);
}

/// A long state is not copied at every step: what a failure loses is made again.
TEST(ResumeAfterFailure, OfALongStateEndsAsTheUninterruptedRun) {
  std::string fine = separate_blocks();
  const std::string coarse = "Transfinite Curve{1:24} = 3;";
  fine.replace(fine.find(coarse), coarse.size(), "Transfinite Curve{1:24} = 10;");
  const Case blocks(fine);
  const config::Config config =
      blocks.config(pressure_probe, {"time.output=[0.5, 1, 1.6, 3]", "time.tolerance=1e-3", "output.fields=[1.6]"});
  ASSERT_GT(System(config).rate.size(), 20000U);
  const std::filesystem::path whole = blocks / "whole", parts = blocks / "parts";
  ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);
  struct Failing final : Observer {
    void output(StepView& view) override {
      if (view.time() == 3) throw SolverError("late");
    }
  } failing;
  EXPECT_EQ(run(config, {.output = parts.string(), .observers = {&failing}}).exit_status, 4);
  EXPECT_EQ(Table(parts / "history.csv").times().back(), 3);
  const Summary resumed = run(config, {.output = parts.string(), .resume = true});
  ASSERT_EQ(resumed.exit_status, 0) << resumed.message;
  for (const char* file : {"history.csv", "fields.pvd"})
    EXPECT_EQ(read_text(parts / file), read_text(whole / file)) << file;
  EXPECT_EQ(Table(parts / "steps.csv").times(), Table(whole / "steps.csv").times());
}

TEST(ResumeAtOnce, FromAnInterruptionBeforeTheFirstStep) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, {"time.output=[1]"});
  EXPECT_EQ(interrupted_run(config, blocks / "out", 1), 0);
  EXPECT_EQ(Table(blocks / "out/history.csv").times(), std::vector<double>{0});
  ASSERT_EQ(run(config, {.output = (blocks / "out").string(), .resume = true}).exit_status, 0);
  EXPECT_EQ(Table(blocks / "out/history.csv").times(), (std::vector<double>{0, 1, 4}));
}

TEST(ResumeMistakes, CheckpointOfAnotherModelAndWhatDiffers) {
  const std::string loads = "[[loads]]\non = 'side_x'\npressure = 0.01\n[temperature]\nvalue = '20+t'\n";
  const Case blocks;
  const std::filesystem::path out = blocks / "out";
  interrupted_run(blocks.config(pressure_probe + loads), out, 1);
  const std::string history = read_text(out / "history.csv"), checkpoint = read_text(out / "checkpoint.h5");
  const std::vector<std::pair<const char*, std::vector<std::string_view>>> changes{
      {"materials.soft.young_modulus=101", {"materials.soft.young_modulus ", "100", "101"}},
      {"materials.hard.creep.0.n=5", {"materials.hard.creep[0].n ", "4", "5"}},
      {"mesh.order=2", {"body 'lower'", "36 nodes"}},
      {"mesh.file=moved.geo", {"body 'upper'", "45 nodes"}},
      {"bodies.upper.material=soft", {"bodies.upper.material ", "\"hard\"", "\"soft\""}},
      {"supports.3.displacement.z=-0.03", {"supports[3].displacement.z ", "-0.025", "-0.03"}},
      {"loads.0.pressure={t=[0,1],values=[0.01,0.02]}",
       {"loads[0].pressure ", "0.01", "{ t = [0, 1], values = [0.01, 0.02] }"}},
      {"loads=[]", {"loads[0].pressure ", "0.01", "missing"}},
      {"temperature.value='20+2*t'", {"temperature.value ", "\"20+t\"", "\"20+2*t\""}},
      {"contacts.0.gap=0.01", {"contacts[0].gap ", "0", "0.01"}},
      {"contacts.0.slave=upper_bottom", {"contacts[0].slave ", "\"lower_top\"", "\"upper_bottom\""}},
      {"contact_solver.method=active_set", {"contact_solver.method ", "\"schwarz\"", "\"active_set\""}}};
  std::string moved = separate_blocks();  // as many nodes, elsewhere
  moved.replace(moved.find("{0, 0, 0, 2, 1, 1}"), 18, "{0, 0, 0, 2, 1, 1.01}");
  moved.replace(moved.find("e = 1e-3"), 8, "e = 0.02");
  io::test::write_text(blocks / "moved.geo", moved);
  for (const auto& [change, facts] : changes) {
    const config::Config config = blocks.config(pressure_probe + loads, {change});
    const std::string message = message_of<ConfigError>([&] { run(config, {.output = out.string(), .resume = true}); });
    EXPECT_TRUE(says(message, {(out / "checkpoint.h5").string() + ": ", "--resume"})) << change;
    EXPECT_TRUE(says(message, facts)) << change;
  }
  EXPECT_EQ(read_text(out / "history.csv"), history);
  EXPECT_EQ(read_text(out / "checkpoint.h5"), checkpoint);
}

/// What may be changed between two parts of a run.
TEST(ResumeChanges, TolerancesTimesAndIntegratorsMay) {
  const Case blocks;
  for (const char* change : {"time.tolerance=1e-5", "time.integrator=arkode_dirk", "time.integrator=beta_euler",
                             "time.output=[0.7, 2]", "contact_solver.tolerance=1e-11", "time.breakpoints=[2.2]"}) {
    const std::filesystem::path out = blocks / change;
    const std::vector<std::string> outputs{"time.output=[0.5, 1, 2]", "time.step=0.125"};
    interrupted_run(blocks.config(pressure_probe, outputs), out, 2);
    std::vector<std::string> changed = outputs;
    changed.emplace_back(change);
    const Summary result = run(blocks.config(pressure_probe, changed), {.output = out.string(), .resume = true});
    EXPECT_EQ(result.exit_status, 0) << change << ": " << result.message;
    expect_relaxed_pressure(Table(out / "history.csv"), 2e-2, change);
  }
}

TEST(ResumeChanges, WhatHasNoEffectOnTheModelMayDiffer) {
  const Case blocks;
  using Overrides = std::vector<std::string>;
  const std::string active_set = "contact_solver.method=active_set";
  const std::vector<std::pair<Overrides, std::string>> changes{
      {Overrides{}, "contact_solver.alpha=0.3"},
      {Overrides{}, "contact_solver.alpha={upper=0.3}"},
      {Overrides{}, "contact_solver.damping=0.9"},
      {Overrides{active_set}, "contact_solver.acceleration=anderson"},
      {Overrides{"contacts=[]", "probes=[]"}, active_set}};
  // The breakpoint ends a step before the last output, however long the steps are.
  const std::vector<std::string> outputs{"time.output=[0.5, 1, 2]", "time.breakpoints=[0.75]"};
  for (const auto& [before, change] : changes) {
    const std::filesystem::path out = blocks / change;
    std::vector<std::string> overrides = before;
    overrides.insert(overrides.end(), outputs.begin(), outputs.end());
    interrupted_run(blocks.config(pressure_probe, overrides), out, 2);
    overrides.push_back(change);
    const Summary result = run(blocks.config(pressure_probe, overrides), {.output = out.string(), .resume = true});
    EXPECT_EQ(result.exit_status, 0) << change << ": " << result.message;
  }
  const std::string sweeps = "contact_solver.acceleration=none";
  interrupted_run(blocks.config(pressure_probe, {outputs[0], sweeps}), blocks / "sweeps", 2);
  EXPECT_THROW(run(blocks.config(pressure_probe, {outputs[0], sweeps, "contact_solver.damping=0.9"}),
                   {.output = (blocks / "sweeps").string(), .resume = true}),
               ConfigError);
}

TEST(ResumeChanges, ALaterEndProlongsACompletedRun) {
  const Case blocks;
  const std::vector<std::string> before{"time.output=[1, 3]"}, after{"time.output=[1, 3, 5, 6]", "time.end=7"};
  for (const char* integrator : {"cvode_bdf", "arkode_erk", "explicit_euler"}) {
    const std::filesystem::path out = blocks / integrator;
    std::vector<std::string> first = before, second = after;
    for (auto* overrides : {&first, &second}) {
      overrides->push_back(std::string("time.integrator=") + integrator);
      overrides->emplace_back("time.step=0.0625");
    }
    ASSERT_EQ(run(blocks.config(pressure_probe, first), {.output = out.string()}).exit_status, 0);
    const std::string steps = read_text(out / "steps.csv");
    ASSERT_EQ(run(blocks.config(pressure_probe, second), {.output = out.string(), .resume = true}).exit_status, 0);
    const Table history(out / "history.csv");
    EXPECT_EQ(history.times(), (std::vector<double>{0, 1, 3, 4, 5, 6, 7})) << "the old end stays";
    expect_relaxed_pressure(history, 5e-3, integrator);
    EXPECT_EQ(read_text(out / "steps.csv").substr(0, steps.size()), steps);
    EXPECT_EQ(SummaryFile(out / "summary.json").number("time_reached"), 7) << integrator;
  }
}

/// A run that begins anew must not be taken for the continuation of the one before it.
TEST(ResumeMistakes, ANewRunForgetsTheOldCheckpoints) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, {"output.checkpoint_seconds=0"});
  const std::filesystem::path out = blocks / "out";
  ASSERT_EQ(run(config, {.output = out.string()}).exit_status, 0);
  ASSERT_TRUE(std::filesystem::exists(out / "checkpoint.previous.h5"));
  struct Failing final : Observer {
    void output(StepView& /*view*/) override { throw SolverError("before the first step"); }
  } failing;
  EXPECT_EQ(run(config, {.output = out.string(), .observers = {&failing}}).exit_status, 4);
  EXPECT_FALSE(std::filesystem::exists(out / "checkpoint.h5"));
  EXPECT_FALSE(std::filesystem::exists(out / "checkpoint.previous.h5"));
}

TEST(ResumeMistakes, DamagedCheckpoints) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe,
      {"output.checkpoint_seconds=0", "time.integrator=beta_euler", "time.step=0.25", "time.output=[0.5, 1, 1.6, 3]"});
  const std::filesystem::path whole = blocks / "whole", out = blocks / "out";
  ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);
  interrupted_run(config, out, 3);
  std::string newest = read_text(out / "checkpoint.h5");
  newest[newest.size() / 2] = static_cast<char>(newest[newest.size() / 2] ^ 1);
  io::test::write_text(out / "checkpoint.h5", newest);
  const std::string older = read_text(out / "checkpoint.previous.h5");
  io::test::write_text(out / "checkpoint.previous.h5", older.substr(0, older.size() - 100));
  const std::string message = message_of<ConfigError>([&] { run(config, {.output = out.string(), .resume = true}); });
  EXPECT_TRUE(says(message, {"checkpoint.h5'", "damaged", "checkpoint.previous.h5'", "damaged", "--resume"}));

  io::test::write_text(out / "checkpoint.previous.h5", older);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(config, {.output = out.string(), .resume = true}).exit_status, 0);
  const std::string warning = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(says(warning, {"checkpoint.h5'", "damaged", "previous", "t = "}));
  for (const char* file : {"history.csv", "steps.csv", "fields.pvd"})
    EXPECT_EQ(read_text(out / file), read_text(whole / file)) << file;
}

TEST(ResumeMistakes, NoCheckpoint) {
  const Case blocks;
  const std::string message =
      message_of<ConfigError>([&] { run(blocks.config(), {.output = (blocks / "out").string(), .resume = true}); });
  EXPECT_TRUE(contains(message, "checkpoint.h5")) << message;
}

TEST(ResumeMistakes, OtherProbes) {
  const Case blocks;
  const std::filesystem::path out = blocks / "out";
  interrupted_run(blocks.config(pressure_probe), out, 1);
  const std::string message =
      message_of<ConfigError>([&] { run(blocks.config(), {.output = out.string(), .resume = true}); });
  EXPECT_TRUE(says(message, {"probes[0].name ", "\"pressure\"", "missing"}));
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
}  // namespace creepcontact::run::test
