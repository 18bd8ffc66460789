#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

struct RunCase {
  const char* integrator;
  double tolerance;  ///< of the pressure against the closed form
  std::vector<std::string> overrides;
};

class Run : public testing::TestWithParam<RunCase> {};

TEST_P(Run, TablesAgreeWithTheSummaryAndTheClosedForm) {
  const Case blocks;
  std::vector<std::string> overrides = GetParam().overrides;
  overrides.push_back(std::string("time.integrator=") + GetParam().integrator);
  overrides.emplace_back("time.output=[0.1, 1, 1.7, 3]");
  const Summary result = run(blocks.config(pressure_probe, overrides), {.output = (blocks / "out").string()});
  ASSERT_EQ(result.exit_status, 0) << result.message;

  const Table history(blocks / "out/history.csv"), steps(blocks / "out/steps.csv");
  EXPECT_EQ(history.names(), (std::vector<std::string>{"time", "pressure"}));
  EXPECT_EQ(history.times(), (std::vector<double>{0, 0.1, 1, 1.7, 3, 4}));
  expect_relaxed_pressure(history, GetParam().tolerance);

  double time = 0;
  for (std::size_t i = 0; i < steps.rows(); ++i) {
    EXPECT_GT(steps.column("step")[i], 0);
    EXPECT_NEAR(steps.times()[i] - time, steps.column("step")[i], 1e-12);
    time = steps.times()[i];
  }
  EXPECT_EQ(time, 4);
  for (const double active : steps.column("active_contacts")) EXPECT_EQ(active, 12);
  for (const double order : steps.column("order")) EXPECT_GE(order, 1);

  const SummaryFile summary(blocks / "out/summary.json");
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_EQ(summary.text("integrator"), GetParam().integrator);
  EXPECT_FALSE(summary.has("message"));
  EXPECT_EQ(summary.number("time_reached"), 4);
  EXPECT_EQ(summary.number("steps"), steps.rows());
  EXPECT_EQ(summary.number("factorizations"), 2);
  // Outputs and the error scale have their solves outside the steps.
  for (const char* count : {"rhs_evaluations", "elastic_solves", "schwarz_iterations"}) {
    EXPECT_GE(summary.number(count), steps.sum(count)) << count;
    EXPECT_GT(steps.sum(count), 0) << count;
  }
  EXPECT_EQ(summary.number("elastic_solves"), summary.number("contact_solves") + summary.number("jacobian_products"));
}

TEST(RunOutputs, AConfigurationMadeInCodeIsCompleted) {
  const Case blocks;
  config::Config config = blocks.config(pressure_probe, {});
  config.time.output = {2};
  config.output.field_times = {3};
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  EXPECT_EQ(Table(blocks / "out/history.csv").times(), (std::vector<double>{0, 2, 3, 4}));
}

TEST(RunOutputs, StepsEndAtOutputTimesIfAsked) {
  const Case blocks;
  for (const char* stop : {"true", "false"}) {
    const std::filesystem::path out = blocks / stop;
    const config::Config config =
        blocks.config(pressure_probe, {"time.output=[0.1, 1, 1.7, 3]", "time.stop_at_output=" + std::string(stop)});
    ASSERT_EQ(run(config, {.output = out.string()}).exit_status, 0);
    const std::vector<double> times = Table(out / "steps.csv").times();
    int found = 0;
    for (const double output : {0.1, 1.0, 1.7, 3.0}) found += static_cast<int>(std::ranges::count(times, output));
    EXPECT_EQ(found, stop == std::string("true") ? 4 : 0) << stop;
    expect_relaxed_pressure(Table(out / "history.csv"), 1e-3, stop);
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, Run,
                         testing::Values(RunCase{"explicit_euler", 5e-3, {"time.step=0.0625"}},
                                         RunCase{"beta_euler", 1e-3, {"time.step=0.25", "time.beta=0.5"}},
                                         RunCase{"cvode_bdf", 1e-3, {}}, RunCase{"arkode_dirk", 1e-3, {}}),
                         [](const auto& tested) { return std::string(tested.param.integrator); });

INSTANTIATE_TEST_SUITE_P(
    Settings, Run,
    testing::Values(RunCase{"explicit_euler", 5e-3, {"time.step=adaptive", "time.tolerance=1e-5"}},
                    RunCase{"beta_euler", 1e-3, {"time.step=adaptive", "time.beta=0.5", "time.inner=newton"}},
                    RunCase{"arkode_erk", 1e-3, {"time.table=ARKODE_DORMAND_PRINCE_7_4_5"}}),
    [](const auto& tested) { return std::string(tested.param.integrator); });

TEST(RunBreakpoints, AreEndsOfSteps) {
  const Case blocks;
  const std::vector<std::string> overrides{"supports.3.displacement.z={t=[0,1,3],values=[-0.01,-0.04,-0.02]}",
                                           "time.breakpoints=[2.5]", "time.output=[0.5, 1, 2, 2.75]"};
  for (const char* integrator : {"cvode_bdf", "explicit_euler"}) {
    std::vector<std::string> all = overrides;
    all.push_back(std::string("time.integrator=") + integrator);
    const std::filesystem::path out = blocks / integrator;
    ASSERT_EQ(run(blocks.config(pressure_probe, all), {.output = out.string()}).exit_status, 0);
    const Table history(out / "history.csv"), steps(out / "steps.csv");
    EXPECT_EQ(history.times(), (std::vector<double>{0, 0.5, 1, 2, 2.75, 4}));
    const std::vector<double> times = steps.times();
    for (const double breakpoint : {1.0, 2.5, 3.0})
      EXPECT_EQ(std::count(times.begin(), times.end(), breakpoint), 1) << integrator << " " << breakpoint;
    // the pressure follows the top: the highest at the first kink
    const std::vector<double> pressure = history.column("pressure");
    EXPECT_EQ(std::max_element(pressure.begin(), pressure.end()) - pressure.begin(), 2) << integrator;
    EXPECT_NEAR(pressure[0], 0.4, 1e-8);
  }
}

TEST(RunElastic, HistoryFollowsTheLoads) {
  const Case blocks;
  const config::Config config =
      blocks.config(pressure_probe,
                    elastic({"time.output=[0.5, 1, 3]", "supports.3.displacement.z=-0.025*t", "contacts.0.gap=0.025"}));
  for (const bool resume : {false, true}) {  // a run that has ended may be resumed: nothing is left to do
    const Summary result = run(config, {.output = (blocks / "out").string(), .resume = resume});
    ASSERT_EQ(result.exit_status, 0) << result.message;
    const Table history(blocks / "out/history.csv"), steps(blocks / "out/steps.csv");
    EXPECT_EQ(history.times(), (std::vector<double>{0, 0.5, 1, 3, 4}));
    EXPECT_EQ(steps.rows(), 0);
    for (const double t : history.times()) EXPECT_NEAR(history.at("pressure", t), std::max(0.0, t - 1), 1e-9);
    const SummaryFile summary(blocks / "out/summary.json");
    EXPECT_EQ(summary.text("status"), "completed");
    EXPECT_EQ(summary.number("steps"), 0);
    EXPECT_EQ(summary.number("time_reached"), 4);
  }
}

TEST(RunFailure, KeepsWhatWasComputed) {
  const Case blocks;
  // The stress grows until the inner iterations no longer contract in a step of this length.
  const config::Config config =
      blocks.config(pressure_probe, {"time.integrator=beta_euler", "time.step=0.25", "time.output=[1, 2, 3]",
                                     "supports.3.displacement.z={t=[0,2,4],values=[-0.025,-0.025,-0.25]}"});
  const Summary result = run(config, {.output = (blocks / "out").string()});
  EXPECT_EQ(result.exit_status, 4);
  EXPECT_TRUE(says(result.message, {"beta_euler: ", "inner_tolerance", (blocks / "out").string()}));

  const Table history(blocks / "out/history.csv"), steps(blocks / "out/steps.csv");
  ASSERT_GE(history.rows(), 3);
  EXPECT_LT(history.rows(), 5);
  EXPECT_EQ(history.times()[2], 2);
  EXPECT_NEAR(history.column("pressure")[1], relaxed_pressure(1), 2e-2);
  const SummaryFile summary(blocks / "out/summary.json");
  EXPECT_EQ(summary.text("status"), "failed");
  EXPECT_TRUE(summary.text("message").starts_with("beta_euler: ")) << summary.text("message");
  EXPECT_EQ(summary.number("time_reached"), steps.times().back());
  EXPECT_EQ(summary.number("steps"), steps.rows());

  // Mended, it goes on from there.
  config::Config mended = config;
  mended.time.integrator = "cvode_bdf";
  const Summary resumed = run(mended, {.output = (blocks / "out").string(), .resume = true});
  EXPECT_EQ(resumed.exit_status, 0) << resumed.message;
  EXPECT_EQ(Table(blocks / "out/history.csv").times(), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(SummaryFile(blocks / "out/summary.json").text("status"), "completed");
}

TEST(RunMistakes, OutputDirectoryThatCannotBe) {
  const Case blocks;
  io::test::write_text(blocks / "file", "");
  const std::string message =
      message_of<ConfigError>([&] { run(blocks.config(), {.output = (blocks / "file/out").string()}); });
  EXPECT_TRUE(contains(message, (blocks / "file/out").string())) << message;
}

TEST(RunMistakes, ProbesAreLookedAtBeforeAnythingIsWritten) {
  const Case blocks;
  const config::Config config = blocks.config("[[probes]]\nname = 'q'\nquantity = 'von_mises'\non = 'tpo'\n");
  EXPECT_THROW(run(config, {.output = (blocks / "out").string()}), ModelError);
  EXPECT_FALSE(std::filesystem::exists(blocks / "out"));
}

TEST(RunOutput, DirectoryOfTheConfigurationAndNoFields) {
  const Case blocks;
  const config::Config config = blocks.config("", {"output.fields=false", "time.end=0.01"});
  ASSERT_EQ(run(config, {.output = ""}).exit_status, 0);
  for (const char* file : {"history.csv", "steps.csv", "summary.json", "checkpoint.h5"})
    EXPECT_TRUE(std::filesystem::exists(blocks / "results" / file)) << file;
  EXPECT_FALSE(std::filesystem::exists(blocks / "results/fields.pvd"));
}

}  // namespace
}  // namespace creepcontact::run::test
