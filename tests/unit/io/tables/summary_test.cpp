#include "creepcontact/io/tables/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "creepcontact/platform/replace_file.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

class SummaryFile : public testing::Test {
 protected:
  nlohmann::json written(const Summary& summary) {
    write_summary(directory_ / "summary.json", summary);
    return nlohmann::json::parse(test::read_text(directory_ / "summary.json"));
  }
  test::TemporaryDirectory directory_;
};

TEST_F(SummaryFile, HasEveryEntryOfTheContract) {
  Summary summary;
  summary.status = Summary::Status::completed;
  summary.integrator = "cvode_bdf";
  summary.version = "0.1.0";
  summary.units = "mm, N";
  summary.time_reached = 1e4;
  summary.steps = 1;
  summary.rejected_steps = 2;
  summary.convergence_failures = 20;
  summary.rhs_evaluations = 3;
  summary.jacobian_products = 4;
  summary.elastic_solves = 5;
  summary.contact_solves = 6;
  summary.schwarz_iterations = 7;
  summary.factorizations = 8;
  summary.bodies["ring"] = {.dofs = 10, .elements = 11, .integration_points = 12, .von_mises = {3, 4, 1}};
  summary.wall_seconds = {36, {1, 2, 3, 4, 5, 6, 7, 8}};
  summary.peak_memory_mb = 99.5;
  const nlohmann::json expected = nlohmann::json::parse(R"({
    "title": "", "units": "mm, N", "version": "0.1.0", "status": "completed", "time_reached": 1e4,
    "integrator": "cvode_bdf", "steps": 1, "rejected_steps": 2, "convergence_failures": 20,
    "rhs_evaluations": 3, "jacobian_products": 4, "elastic_solves": 5, "contact_solves": 6, "schwarz_iterations": 7, "factorizations": 8,
    "bodies": {"ring": {"dofs": 10, "elements": 11, "integration_points": 12,
      "initial_von_mises": 3.0, "largest_von_mises": 4.0, "final_von_mises": 1.0}},
    "wall_seconds": {"total": 36.0, "prepare": 1.0, "factorize": 2.0, "solve": 3.0, "material": 4.0, "contact": 5.0,
      "integrate": 6.0, "observe": 7.0, "output": 8.0},
    "peak_memory_mb": 99.5, "accuracy": {"tolerance": 0.0}})");
  EXPECT_EQ(written(summary), expected);
}

TEST_F(SummaryFile, IsReadBackWhole) {
  Summary summary;
  summary.title = "fit";
  summary.units = "mm, N";
  summary.version = "0.2.0";
  summary.integrator = "auto";
  summary.method = "log_adams";
  summary.steps = 7;
  summary.time_reached = 1e5;
  summary.bodies["ring"] = {.dofs = 10, .elements = 11, .integration_points = 12, .von_mises = {3, 4, 1}};
  summary.contacts["seat"] = {{100, 120, 40}, 0.05, 2.5, 0.01, 7.0};
  summary.contacts["plain"] = {{1, 1, 1}, {}, {}, {}, {}};
  summary.damage["ring"] = {0.5, {1, 2, 3}};
  summary.life_fraction["ring"] = {0.25, {4, 5, 6}};
  summary.rupture = {9.5, "ring", {0.99, {7, 8, 9}}};
  summary.probes["p"] = {
      "von_mises", "von Mises stress", Dimension::stress, "", "MPa", "", SummaryProbe::Course{1, 2, 0, 3, 4, 5}};
  summary.probes["q"] = {"", "", Dimension::none, "", "", "2*p", {}};
  summary.events = {{"leak", 12.0}, {"never", std::nullopt}};
  summary.friction_kappa = 0.3;
  summary.wall_seconds = {36, {1, 2, 3, 4, 5, 6, 7, 8}};
  summary.accuracy = {1e-4, 0.1, 0.9, 1e-12};
  summary.warnings = {"one", "two"};
  const nlohmann::json first = written(summary);
  const auto read = read_summary(directory_ / "summary.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(written(*read), first);
}

TEST_F(SummaryFile, TellsFailuresAndInterruptions) {
  Summary summary;
  summary.status = Summary::Status::failed;
  summary.message = "contact: no convergence";
  EXPECT_EQ(written(summary)["status"], "failed");
  EXPECT_EQ(written(summary)["message"], "contact: no convergence");
  summary.status = Summary::Status::ruptured;
  EXPECT_EQ(written(summary)["status"], "ruptured");
  summary.status = Summary::Status::interrupted;
  EXPECT_EQ(written(summary)["status"], "interrupted");
  EXPECT_TRUE(written(summary)["bodies"].is_object());
}

TEST_F(SummaryFile, TextInAnotherEncodingIsReplacedNotFatal) {
  Summary summary;
  summary.title = "caf\xe9";
  EXPECT_EQ(written(summary)["title"], "caf\xEF\xBF\xBD");
}

TEST_F(SummaryFile, ReplacesWithoutLeavingAnythingAside) {
  written({});
  written({});
  EXPECT_FALSE(std::filesystem::exists(platform::aside(directory_ / "summary.json")));
}

TEST_F(SummaryFile, ADirectoryThatIsNotThereIsAnError) {
  EXPECT_TRUE(test::says(test::message_of<Error>([&] { write_summary(directory_ / "none/summary.json", {}); }),
                         {"No such file or directory"}));
}

TEST_F(SummaryFile, TellsOfLifeOnlyWhatIsKnown) {
  Summary summary;
  for (const char* key : {"damage", "life_fraction", "rupture", "contacts"})
    EXPECT_FALSE(written(summary).contains(key));
  summary.damage["blade"] = {0.25, {1, 2, 3}};
  summary.life_fraction["blade"] = {0.5, {4, 5, 6}};
  summary.rupture = {7.0, "blade", {0.99, {1, 2, 3}}};
  summary.contacts["fit"].normal_force = {.start = 150, .largest = 200, .end = 50};
  const auto json = written(summary);
  EXPECT_EQ(json["damage"]["blade"]["largest"], 0.25);
  EXPECT_EQ(json["life_fraction"]["blade"]["place"][2], 6.0);
  EXPECT_EQ(json["rupture"]["time"], 7.0);
  EXPECT_EQ(json["rupture"]["body"], "blade");
  EXPECT_EQ(json["contacts"]["fit"]["remaining_fraction"], 0.25);
}

TEST_F(SummaryFile, HeadingIsReadBack) {
  Summary summary;
  EXPECT_FALSE(written(summary).contains("probes"));
  summary.title = "Fit";
  summary.units = "mm, N";
  summary.status = Summary::Status::failed;
  summary.probes["p"] = {"contact_pressure", "contact pressure", Dimension::stress, "surface"};
  write_summary(directory_ / "summary.json", summary);
  const SummaryHeading heading = read_summary_heading(directory_ / "summary.json");
  EXPECT_EQ(heading.title, "Fit");
  EXPECT_EQ(heading.units, "mm, N");
  EXPECT_EQ(heading.status, "failed");
  EXPECT_EQ(heading.probes, summary.probes);
}

TEST_F(SummaryFile, ProbesAndEvents) {
  Summary summary;
  EXPECT_FALSE(written(summary).contains("events"));
  summary.probes["p"] = {.quantity = "gap",
                         .label = "gap",
                         .dimension = Dimension::length,
                         .unit = "mm",
                         .course = SummaryProbe::Course{1, 2, NAN, 4, 5, 6}};
  summary.probes["e"] = {.label = "e", .unit = "", .expression = "2*p"};
  summary.events = {{"leak", 2.5}, {"never", std::nullopt}};
  const auto json = written(summary);
  EXPECT_EQ(json["probes"]["p"]["start"], 1.0);
  EXPECT_EQ(json["probes"]["p"]["end"], 2.0);
  EXPECT_TRUE(json["probes"]["p"]["min"].is_null());
  EXPECT_EQ(json["probes"]["p"]["t_max"], 6.0);
  EXPECT_EQ(json["probes"]["p"]["unit"], "mm");
  EXPECT_EQ(json["probes"]["e"]["expression"], "2*p");
  EXPECT_EQ(json["events"]["leak"], 2.5);
  EXPECT_TRUE(json["events"]["never"].is_null());
  write_summary(directory_ / "summary.json", summary);
  const SummaryHeading heading = read_summary_heading(directory_ / "summary.json");
  EXPECT_EQ(heading.events, (std::map<std::string, double>{{"leak", 2.5}}));
  EXPECT_EQ(heading.probes.at("e").expression, "2*p");
  EXPECT_EQ(heading.probes.at("p").unit, "mm");
  EXPECT_EQ(read_summary(directory_ / "summary.json")->events, summary.events);
}

TEST_F(SummaryFile, HeadingOfAnotherFile) {
  const auto message = [&](const char* text) {
    const auto path = test::write_text(directory_ / "summary.json", text);
    return test::message_of<ConfigError>([&] { read_summary_heading(path); });
  };
  EXPECT_TRUE(test::says(message("{\"title\": "), {"summary.json'", "JSON"}));
  EXPECT_EQ(message("{\"title\": 7, \"probes\": [1]}"), "nothing was thrown");
}

}  // namespace
}  // namespace creepcontact::io
