/// Events, and what summary.json says of probes. Without creep loads give the times in closed form; with creep the
/// blocks relax by sigma^-3 = 1 + 0.36 t (relaxed_pressure()).

#include <cmath>
#include <map>

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

const std::string pressure_events = pressure_probe + R"(
[[probes]]
name = "force"
expression = "2*pressure"
unit = "N"
[[events]]
name = "leak"
when = "pressure < 0.8"
[[events]]
name = "early"
when = "force < 1.9 && t > 0"
[[events]]
name = "at once"
when = "pressure > 0.5"
[[events]]
name = "never"
when = "pressure < 0.1 || t > 100"
)";

/// When the pressure has fallen to this.
double time_of_pressure(double pressure) {
  return (std::pow(pressure, -3) - 1) / 0.36;
}

SummaryFile summary_of(const config::Config& config, const std::filesystem::path& out, bool resume = false) {
  const Summary result = run(config, {.output = out.string(), .resume = resume});
  EXPECT_EQ(result.exit_status, 0) << result.message;
  return SummaryFile(out / "summary.json");
}

class Events : public testing::TestWithParam<const char*> {};

TEST_P(Events, OfARelaxingPressure) {
  const Case blocks;
  const config::Config config =
      blocks.config(pressure_events, {std::string("time.integrator=") + GetParam(), "time.tolerance=1e-7",
                                      "time.output=[1, 3]", "time.step=1e-3", "output.fields=false"});
  const SummaryFile summary = summary_of(config, blocks / "out");
  const double accuracy = std::string(GetParam()) == "explicit_euler" ? 2e-3 : 1e-4;
  EXPECT_NEAR(summary.number("events/leak"), time_of_pressure(0.8), accuracy);
  EXPECT_NEAR(summary.number("events/early"), time_of_pressure(0.95), accuracy);
  EXPECT_EQ(summary.number("events/at once"), 0);
  EXPECT_TRUE(summary.has("events/never"));
  EXPECT_THROW(summary.number("events/never"), std::exception);  // null
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_EQ(Table(blocks / "out" / "history.csv").times(), (std::vector<double>{0, 1, 3, 4}));
}

INSTANTIATE_TEST_SUITE_P(Integrators, Events, testing::Values("auto", "cvode_bdf", "arkode_erk", "explicit_euler"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(EventsOfRuns, CostFewSolves) {
  const Case blocks;
  const auto solves = [&](const std::string& events) {
    const Summary summary =
        run(blocks.config(pressure_probe + events, {"time.tolerance=1e-5", "output.fields=false"}), {});
    EXPECT_EQ(summary.exit_status, 0) << summary.message;
    EXPECT_GT(summary.results.steps, 15);
    return summary.results.elastic_solves;
  };
  const auto alone = solves("");
  EXPECT_LE(solves("[[events]]\nname = 'never'\nwhen = 'pressure < 0.1'\n"), alone + 2);
  EXPECT_LE(solves("[[events]]\nname = 'leak'\nwhen = 'pressure < 0.8'\n"), alone + 12);
}

TEST(EventsOfRuns, StopWithALastRow) {
  const Case blocks;
  const std::string stop = pressure_events + "[[events]]\nname = 'stop'\nwhen = 'pressure < 0.9'\nstop = true\n";
  const config::Config config = blocks.config(stop, {"time.tolerance=1e-7", "time.output=[0.5, 3]"});
  const SummaryFile summary = summary_of(config, blocks / "out");
  const double end = time_of_pressure(0.9);
  EXPECT_NEAR(summary.number("events/stop"), end, 1e-4);
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_EQ(summary.number("time_reached"), summary.number("events/stop"));
  EXPECT_THROW(summary.number("events/leak"), std::exception);  // it would come later
  const Table history(blocks / "out" / "history.csv");
  ASSERT_EQ(history.rows(), 3u);
  EXPECT_EQ(history.times()[2], summary.number("events/stop"));
  EXPECT_NEAR(history.column("pressure")[2], 0.9, 1e-9);
  EXPECT_LT(history.column("pressure")[2], 0.9);

  const Summary again = run(config, {.output = (blocks / "out").string(), .resume = true});
  EXPECT_TRUE(says(again.message, {"event 'stop'", "t = ", "stop = false"}));
  // Without the stop the run goes on to its end.
  const config::Config further =
      blocks.config(stop, {"time.tolerance=1e-7", "time.output=[0.5, 3]", "events.4.stop=false"});
  const SummaryFile whole = summary_of(further, blocks / "out", true);
  EXPECT_EQ(whole.number("time_reached"), 4);
  EXPECT_NEAR(whole.number("events/leak"), time_of_pressure(0.8), 1e-4);
  EXPECT_EQ(Table(blocks / "out" / "history.csv").times(), (std::vector<double>{0, 0.5, 3, 4}));
}

TEST(EventsOfRuns, StopAtTheStart) {
  const Case blocks;
  const config::Config config =
      blocks.config(pressure_probe + "[[events]]\nname = 'now'\nwhen = 'pressure > 0.5'\nstop = true\n");
  const SummaryFile summary = summary_of(config, blocks / "out");
  EXPECT_EQ(summary.number("events/now"), 0);
  EXPECT_EQ(summary.text("status"), "completed");
  EXPECT_EQ(Table(blocks / "out" / "history.csv").times(), std::vector<double>{0});
}

TEST(EventsOfRuns, OfLinearLoadsWithoutCreep) {
  // The pressure is 40 times the displacement: it grows by 0.3 per time.
  const Case blocks;
  const config::Config config =
      blocks.config(pressure_probe +
                        "[[events]]\nname = 'tight'\nwhen = 'pressure >= 0.9'\n[[events]]\nname = 'stop'\nwhen = "
                        "'pressure > 1.05'\nstop = true\n",
                    elastic({"supports.3.displacement.z='-0.0075*t'", "time.output=[1, 2]"}));
  const SummaryFile summary = summary_of(config, blocks / "out");
  EXPECT_NEAR(summary.number("events/tight"), 3, 1e-8);
  EXPECT_NEAR(summary.number("events/stop"), 3.5, 1e-8);
  EXPECT_EQ(Table(blocks / "out" / "history.csv").rows(), 4u);
}

/// The blocks are lifted off each other: pressure 40 (0.03 - t / 1000) at first, then the gap t / 1000 - 0.03.
const std::string lifted_events = pressure_probe + R"(
[[probes]]
name = "opening"
quantity = "gap"
on = "upper_bottom"
[[events]]
name = "open"
when = "opening > 0"
[[events]]
name = "lifted"
when = "opening > 1e-9"
[[events]]
name = "high"
when = "opening > 2e-3"
[[events]]
name = "loose"
when = "pressure <= 0"
[[events]]
name = "almost loose"
when = "pressure < 1e-9"
[[events]]
name = "light"
when = "pressure < 0.1"
)";
const std::vector<std::string> lift{"supports.3.displacement.z='-0.025 + 1e-3*t'", "contacts.0.gap=-0.005",
                                    "time.end=40", "sensitivity.keys=['contacts[0].gap']", "output.fields=false"};

TEST(EventsOfRuns, OfAnOpeningContactAndTheirDerivatives) {
  const Case blocks;
  const Summary summary = run(blocks.config(lifted_events, elastic(lift)), {});
  ASSERT_EQ(summary.exit_status, 0) << summary.message;
  const std::map<std::string, double> times{{"open", 30},  {"lifted", 30 + 1e-6},         {"high", 32},
                                            {"loose", 30}, {"almost loose", 30 - 2.5e-8}, {"light", 27.5}};
  for (const auto& [name, time] : times) {
    EXPECT_NEAR(summary.results.events.at(name).value(), time, 1e-7) << name;
    EXPECT_NEAR(summary.results.sensitivities.at(0).events.at(name), -1000, 1e-2) << name;
  }
}

/// Later creep moves no event any more: all are moved by as much as the opening, which central differences give.
TEST(EventsOfRuns, DerivativesOfAnOpeningCreepingContact) {
  const Case blocks;
  const auto with = [&](const std::string& setting) {
    std::vector<std::string> settings = lift;
    settings.insert(settings.end(), {"time.tolerance=1e-7", setting});
    Summary summary = run(blocks.config(lifted_events, settings), {});
    EXPECT_EQ(summary.exit_status, 0) << summary.message;
    return summary.results;
  };
  const auto more = with("contacts.0.gap=-0.004995"), less = with("contacts.0.gap=-0.005005");
  const auto here = with("contacts.0.gap=-0.005");
  for (const char* name : {"open", "lifted", "high", "loose", "almost loose"}) {
    const double difference = (more.events.at(name).value() - less.events.at(name).value()) / 1e-5;
    EXPECT_NEAR(here.sensitivities.at(0).events.at(name) / difference, 1, 2e-4) << name;
    EXPECT_NEAR(here.sensitivities.at(0).events.at(name) / here.sensitivities.at(0).events.at("high"), 1, 1e-5) << name;
  }
}

/// A vibration of the loads is followed without creep, too, whatever the output times.
TEST(EventsOfRuns, OfFastLoadsWithoutCreep) {
  const Case blocks;
  const std::string event = pressure_probe + R"([[events]]
name = "high"
when = "pressure > 1.3"
[[events]]
name = "late"
when = "pressure > 1.3 && t > 500"
)";
  for (const char* output : {"time.output=[1000]", "time.output={count=7}"}) {
    const Summary summary =
        run(blocks.config(event, elastic({"supports.3.displacement.z='-0.025*(1 + 0.6*sin(2*pi*t/10))'",
                                          "time.end=1000", output, "output.fields=false"})),
            {});
    ASSERT_EQ(summary.exit_status, 0) << summary.message;
    EXPECT_NEAR(summary.results.events.at("high").value(), 10.0 / 12, 1e-6) << output;
    EXPECT_NEAR(summary.results.events.at("late").value(), 500 + 10.0 / 12, 1e-6) << output;
    EXPECT_NEAR(summary.results.probes.at("pressure").course.value().max, 1.6, 1e-3) << output;
  }
}

TEST(EventsOfRuns, OfJumpsHaveTheTimeOfTheJump) {
  const Case blocks;
  const std::string jump = "supports.3.displacement.z={ t = [0, 2.5, 2.5], values = [-0.01, -0.01, -0.025] }";
  const std::string event = pressure_probe + "[[events]]\nname = 'tight'\nwhen = 'pressure > 0.6'\nstop = true\n";
  for (const bool creeps : {false, true}) {
    std::vector<std::string> overrides{jump, "time.output=[1, 3]"};
    if (!creeps) overrides = elastic(overrides);
    const std::filesystem::path out = blocks / (creeps ? "creep" : "elastic");
    const SummaryFile summary = summary_of(blocks.config(event, overrides), out);
    EXPECT_EQ(summary.number("events/tight"), 2.5);
    EXPECT_EQ(Table(out / "history.csv").times(), (std::vector<double>{0, 1, 2.5}));
    EXPECT_GT(Table(out / "history.csv").column("pressure").back(), 0.9);
  }
}

TEST(EventsOfRuns, WithFrictionAndWithoutCreep) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe + "[[events]]\nname = 'tight'\nwhen = 'pressure > 0.9'\nstop = true\n",
      elastic({"supports.3.displacement.z='-0.0075*t'", "contacts.0.friction=0.2", "time.output=[1, 2]"}));
  const SummaryFile summary = summary_of(config, blocks / "out");
  EXPECT_GT(summary.number("events/tight"), 2);
  const Table history(blocks / "out" / "history.csv");
  EXPECT_NEAR(history.column("pressure").back(), 0.9, 1e-8);
  EXPECT_EQ(history.times().back(), summary.number("events/tight"));
}

TEST(EventsOfRuns, AreTheSameAfterAResume) {
  const Case blocks;
  for (const char* integrator : {"explicit_euler", "arkode_erk"}) {
    const config::Config config =
        blocks.config(pressure_events, {std::string("time.integrator=") + integrator, "time.step=0.25",
                                        "time.output=[0.25, 1, 1.6, 3]", "output.checkpoint_seconds=0"});
    const std::filesystem::path whole = blocks / integrator, parts = blocks / (std::string(integrator) + "_parts");
    const SummaryFile expected = summary_of(config, whole);
    for (int outputs = 2; outputs <= 4; ++outputs) {
      std::filesystem::remove_all(parts);
      InterruptAtOutput interrupt(outputs);
      EXPECT_EQ(run(config, {.output = parts.string(), .observers = {&interrupt}}).exit_status, 130);
      const SummaryFile found = summary_of(config, parts, true);
      for (const char* key :
           {"events/leak", "events/early", "events/at once", "probes/pressure/start", "probes/pressure/end",
            "probes/pressure/min", "probes/pressure/max", "probes/pressure/t_min", "probes/pressure/t_max"})
        EXPECT_EQ(found.number(key), expected.number(key)) << integrator << " " << key;
    }
  }
}

TEST(ProbesOfRuns, InTheSummary) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_events +
                                                  "[[probes]]\nname = 'kilo'\nquantity = 'contact_force_z'\non = "
                                                  "'upper_bottom'\nscale = 1e-3\n[[probes]]\nname = 'area'\nquantity = "
                                                  "'contact_area'\non = 'upper_bottom'\n",
                                              {"time.output=[1, 3]", "units='mm, N, MPa, h'"});
  const SummaryFile summary = summary_of(config, blocks / "out");
  const Table history(blocks / "out" / "history.csv");
  for (const std::string name : {"pressure", "force"}) {
    const std::vector<double>& values = history.column(name);
    const std::string key = "probes/" + name + "/";
    EXPECT_EQ(summary.number(key + "start"), values.front());
    EXPECT_EQ(summary.number(key + "end"), values.back());
    EXPECT_EQ(summary.number(key + "max"), values.front());
    EXPECT_EQ(summary.number(key + "min"), values.back());
    EXPECT_EQ(summary.number(key + "t_max"), 0);
    EXPECT_EQ(summary.number(key + "t_min"), 4);
  }
  EXPECT_EQ(summary.text("probes/pressure/unit"), "MPa");
  EXPECT_EQ(summary.text("probes/force/unit"), "N");
  EXPECT_EQ(summary.text("probes/force/expression"), "2*pressure");
  EXPECT_EQ(summary.text("probes/kilo/unit"), "");
  EXPECT_EQ(summary.text("probes/area/unit"), "mm²");
}

}  // namespace
}  // namespace creepcontact::run::test
