/// Studies: what is read, which runs come of it, and every mistake at its place.
#include "creepcontact/config/study.hpp"

#include <fmt/format.h>

#include <fstream>

#include "complaints.hpp"
#include "config_fixture.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

using Lines = std::vector<std::string>;

const std::string head = "title = \"cost\"\nbase = \"block.toml\"\n";
const std::string compared = "[reference]\nset = { \"time.tolerance\" = 1e-8 }\n[compare]\nquantities = [\"q\"]\n";

Study parsed(const std::string& text) {
  return parse_study(text, "studies/cost.toml");
}

void expect_begin(const std::string& line, std::initializer_list<std::string_view> facts) {
  EXPECT_TRUE(line.starts_with(*facts.begin())) << *facts.begin() << "\n--- in\n" << line;
  EXPECT_TRUE(creepcontact::test::says(line, facts));
}

/// The only one begins with the first fact and names the others.
void expect_complaint(const std::string& text, std::initializer_list<std::string_view> facts) {
  const Lines lines = complaints([&] { parsed(text); });
  ASSERT_EQ(lines.size(), 1u) << (lines.empty() ? "no mistake found" : lines[0] + "\n" + lines.back());
  expect_begin(lines[0], facts);
}

std::string axis(const std::string& key, const std::string& values, const std::string& more = "") {
  return "[[axes]]\nkey = \"" + key + "\"\nvalues = " + values + "\n" + more;
}

Lines settings_of(const PlannedRun& run) {
  Lines all;
  for (const Setting& setting : run.settings) all.push_back(setting.override_text());
  return all;
}

TEST(StudyReading, EveryKey) {
  const Study study =
      parsed(head + "set = { output.fields = false }\n" + axis("time.step", "[1, 0.5]", "zip = \"a\"\n") +
             "[[runs]]\nset = { \"time.integrator\" = \"cvode_bdf\", time.output = [1, 2.5] }\n" + compared +
             "norm = \"final\"\n");
  EXPECT_EQ(study.title, "cost");
  EXPECT_EQ(study.base, "studies/block.toml");
  ASSERT_EQ(study.axes.size(), 1u);
  EXPECT_EQ(study.axes[0].key.name, "time.step");
  EXPECT_EQ(study.axes[0].zip, "a");
  EXPECT_EQ(study.axes[0].values[1].toml, "0.5");
  ASSERT_EQ(study.runs.size(), 1u);
  EXPECT_EQ(study.runs[0].settings[0].value.label, "cvode_bdf");
  EXPECT_EQ(study.runs[0].settings[1].override_text(), "time.output=[1, 2.5]");
  EXPECT_EQ(overrides(study, study.reference->settings), (Lines{"output.fields=false", "time.tolerance=1e-08"}));
  EXPECT_EQ(study.compare.norm, ErrorNorm::final);
}

TEST(StudyReading, SettingsUnderNamesWithBlanks) {
  const Study study = parsed(head + "[[runs]]\n[runs.set]\nmaterials.\"old steel\".E = 1\n'a.\"b c\".d' = 2\n");
  EXPECT_EQ(study.runs[0].settings[0].key, "materials.\"old steel\".E");
  EXPECT_EQ(study.runs[0].settings[1].key, "a.\"b c\".d");
}

TEST(StudyReading, ValuesOfAnyTypeAsOverridesTakeThem) {
  const Study study = parsed(head + axis("k", "[[0.1,\n 'a\"b'], { t = [0, 1.0], f = true }, 1e-7]"));
  EXPECT_EQ(study.axes[0].values[0].toml, "[0.1, 'a\"b']");
  EXPECT_EQ(study.axes[0].values[1].toml, "{ f = true, t = [0, 1.0] }");
  EXPECT_EQ(study.axes[0].values[2].toml, "1e-07");
}

TEST(StudyReading, ProductsBeyondAllBounds) {
  std::string text = head;
  for (int i = 0; i < 30; ++i) text += axis(fmt::format("key_{}", i), "[1, 2, 3, 4, 5, 6, 7, 8, 9, 10]");
  expect_complaint(text, {"studies/cost.toml:3:1: axes[0]: ", "1e+30", "10000"});
}

TEST(StudyReading, ClosedFormsAsReference) {
  const Study study = parsed(head + axis("time.step", "[1]") +
                             "[reference]\nexpressions = { q = \"2*t\" }\n[compare]\nquantities = [\"q\"]\n");
  EXPECT_FALSE(study.reference->is_run());
  EXPECT_DOUBLE_EQ(study.reference->expressions.at("q")({.t = 3}), 6);
}

TEST(StudyReading, CommentsAndLayoutDoNotCount) {
  const std::string text = head + axis("time.step", "[1, 2]");
  EXPECT_EQ(parsed(text).normalized, parsed("# asks\n" + head + "\n" + axis("time.step", "[1,\n 2]")).normalized);
  EXPECT_NE(parsed(text).normalized, parsed(head + axis("time.step", "[1, 3]")).normalized);
}

TEST(StudyPlan, ProductOfTheAxesThenSingleRuns) {
  const Study study =
      parsed(head + axis("a.x", "[1, 2]") + axis("b", "[\"u\", \"v\", \"w\"]") + "[[runs]]\nset = { c = true }\n");
  const std::vector<PlannedRun> runs = plan(study);
  ASSERT_EQ(runs.size(), 7u);
  EXPECT_EQ(settings_of(runs[0]), (Lines{"a.x=1", "b='u'"}));
  EXPECT_EQ(settings_of(runs[1]), (Lines{"a.x=1", "b='v'"}));
  EXPECT_EQ(settings_of(runs[5]), (Lines{"a.x=2", "b='w'"}));
  EXPECT_EQ(settings_of(runs[6]), (Lines{"c=true"}));
  EXPECT_EQ(runs[5].point, (std::vector<int>{1, 2}));
  EXPECT_EQ(runs[6].product, 1u);
  EXPECT_TRUE(runs[6].point.empty());
  EXPECT_EQ(runs[6].name, "run_007");
}

TEST(StudyPlan, ZippedAxesRunTogether) {
  const Study study =
      parsed(head + axis("a", "[1, 2]", "zip = \"z\"\n") + axis("b", "[5, 6]") + axis("c", "[3, 4]", "zip = \"z\"\n"));
  const std::vector<PlannedRun> runs = plan(study);
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(settings_of(runs[1]), (Lines{"a=1", "b=6", "c=3"}));
  EXPECT_EQ(settings_of(runs[2]), (Lines{"a=2", "b=5", "c=4"}));
}

TEST(StudyPlan, RunsWithAxesOfTheirOwn) {
  const Study study = parsed(head + axis("a", "[1, 2]") + R"(
[[runs]]
label = "BDF"
set = { c = 0 }
axes = [{ key = "b", values = [3, 4] }, { key = "a", values = [5] }]
[plot]
over = "b"
show = ["schwarz_iterations"]
)");
  const std::vector<PlannedRun> runs = plan(study);
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(settings_of(runs[3]), (Lines{"c=0", "b=4", "a=5"}));
  EXPECT_EQ(runs[3].product, 1u);
  EXPECT_EQ(runs[3].point, (std::vector<int>{1, 0}));
  EXPECT_EQ(axis_of_curves(study, products(study)[0]), 0u);
  EXPECT_EQ(axis_of_curves(study, products(study)[1]), 0u);
  EXPECT_EQ(products(study)[1].label, "BDF");
}

TEST(StudyReading, NamesAndPicturesMakeNoOtherStudy) {
  const std::string runs = "[[runs]]\nset = { c = 1 }\n";
  const std::string one = parsed(head + runs).normalized;
  EXPECT_EQ(parsed("title = \"else\"\nbase = \"block.toml\" # here\n" + runs + "label = \"d\"\n[plot]\nshow = []\n")
                .normalized,
            one);
  EXPECT_NE(parsed(head + "[[runs]]\nset = { c = 2 }\n").normalized, one);
}

TEST(StudyPlan, CurvesRunAlongNumbers) {
  const auto along = [](const std::string& axes, const std::string& plot = "") {
    const Study study = parsed(head + axes + plot);
    const auto found = axis_of_curves(study, products(study)[0]);
    return found ? products(study)[0].axes[*found].key.name : "";
  };
  const std::string words = axis("w", "[\"u\", \"v\"]"), step = axis("time.step", "[1, 2]"),
                    beta = axis("beta", "[1, 2]");
  EXPECT_EQ(along(step + beta + words), "time.step");
  EXPECT_EQ(along(step + beta + words, "[plot]\nover = [\"beta\", \"time.step\"]\n"), "beta");
  EXPECT_EQ(along(axis("time.step", "[1, \"stable\", 2]") + beta), "time.step");
  EXPECT_EQ(along(beta + axis("last", "[1, 2]") + axis("one", "[1]") + words), "last");
  EXPECT_EQ(along(words), "");
}

TEST(StudyMistakes, AtTheirPlaces) {
  const std::string one = axis("time.step", "[1]");
  expect_complaint(head + one + "valeus = [3]\n", {"studies/cost.toml:6:1: axes[0].valeus: ", "'values'"});
  expect_complaint(axis("time.step", "[1]"), {"studies/cost.toml:1:1: base: ", "missing"});
  expect_complaint(head, {"studies/cost.toml:1:1: ", "[[axes]]", "[[runs]]"});
  expect_complaint(head + axis("time.step", "[]"), {"studies/cost.toml:5:10: axes[0].values: ", "empty"});
  expect_complaint(head + one + one, {"studies/cost.toml:7:7: axes[1].key: ", "'time.step'", "line 4"});
  expect_complaint(head + axis("a", "[1, 2]", "zip = \"z\"\n") + axis("b", "[1]", "zip = \"z\"\n"),
                   {"studies/cost.toml:7:1: axes[1]: ", "1", "'b'", "2", "'a'"});
  expect_complaint(head + one + "[compare]\nquantities = [\"q\"]\nnorm = \"max\"\n",
                   {"studies/cost.toml:8:8: compare.norm: ", "[reference]"});
  expect_complaint(head + one + "[reference]\nset = {}\n", {"studies/cost.toml:6:1: reference: ", "[compare]"});
  expect_complaint(head + one + "[reference]\n[compare]\nquantities = [\"q\"]\n",
                   {"studies/cost.toml:6:1: reference: ", "'set'", "'csv'", "'expressions'"});
  expect_complaint(head + one + "[reference]\nexpressions = { p = \"t\" }\n[compare]\nquantities = [\"q\"]\n",
                   {"studies/cost.toml:9:15: compare.quantities[0]: ", "'q'", "[reference]"});
  expect_complaint(head + one + "[plot]\nover = \"time.stepp\"\n",
                   {"studies/cost.toml:7:8: plot.over: ", "'time.stepp'", "'time.step'"});
  expect_complaint(head + one + axis("w", "[\"u\"]") + "[plot]\nover = \"w\"\n",
                   {"studies/cost.toml:10:8: plot.over: ", "'w'", "numbers"});
  expect_complaint(head + one + "[plot]\nshow = [\"solves\"]\n", {"studies/cost.toml:7:9: plot.show[0]: ", "'solves'"});
  expect_complaint(head + "[[runs]]\nlabel = \"x\"\n", {"studies/cost.toml:3:1: runs[0]: ", "'set'", "'axes'"});
  expect_complaint(head + one + "[reference]\nexpressions = { q = \"t + s\" }\n[compare]\nquantities = [\"q\"]\n",
                   {"studies/cost.toml:7:21: reference.expressions.q: ", "'t + s'"});
}

/// Runs of a base configuration on disk.
class StudyRuns : public testing::Test {
 protected:
  void SetUp() override {
    // Tests run side by side.
    directory_ /= std::string("creepcontact_") + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(directory_);
    std::ofstream(directory_ / "base.toml")
        << minimal << "[[probes]]\nname = \"q\"\nquantity = \"von_mises\"\nbody = \"block\"\n";
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  Lines mistakes_of(const std::string& rest) const {
    const Study study = parse_study("base = \"base.toml\"\n" + rest, directory_ / "study.toml");
    return complaints([&] { check_runs(study, plan(study), test_vocabulary()); });
  }
  std::string at(const std::string& where) const { return (directory_ / "study.toml").string() + where; }

  std::filesystem::path directory_ = testing::TempDir();
};

TEST_F(StudyRuns, RightOnes) {
  EXPECT_EQ(mistakes_of(axis("time.step", "[1, 2]") + compared), Lines{});
}

TEST_F(StudyRuns, UnknownKeyIsNamedOnce) {
  const Lines lines = mistakes_of(axis("time.stepp", "[1, 2, 3]"));
  ASSERT_EQ(lines.size(), 1u);
  expect_begin(lines[0], {at(":3:7: axes[0].key: time.stepp: "), "'step'"});
}

TEST_F(StudyRuns, WrongValueIsNamedAtItsPlace) {
  const Lines lines = mistakes_of(axis("time.step", "[1, -2]") + axis("time.beta", "[0.5, 1]"));
  ASSERT_EQ(lines.size(), 1u);
  expect_begin(lines[0], {at(":4:14: axes[0].values[1]: time.step: "), "-2"});
}

TEST_F(StudyRuns, ReferenceIsCheckedToo) {
  const Lines lines = mistakes_of(axis("time.step", "[1]") +
                                  "[reference]\nset = { \"time.tolerance\" = 7 }\n[compare]\nquantities = [\"q\"]\n");
  ASSERT_EQ(lines.size(), 1u);
  expect_begin(lines[0], {at(":6:28: reference.set.time.tolerance: time.tolerance: "), "7"});
}

TEST_F(StudyRuns, MistakesBetweenSettingsAndBaseAreNamedOnce) {
  std::ofstream(directory_ / "base.toml", std::ios::app) << "[contact_solver]\ntolerance = -1\n";
  const Lines lines = mistakes_of(axis("time.step", "[1, 2]") + "[[runs]]\nset = { time.end = 3 }\n");
  ASSERT_EQ(lines.size(), 1u);
  expect_begin(lines[0], {at(":2:1: axes[0]: "), "contact_solver.tolerance: ", "-1"});
}

TEST_F(StudyRuns, BaseMustBeThere) {
  const Study study = parse_study("base = \"gone.toml\"\n" + axis("time.step", "[1, 2]"), directory_ / "study.toml");
  const Lines lines = complaints([&] { check_runs(study, plan(study), test_vocabulary()); });
  ASSERT_EQ(lines.size(), 1u);
  expect_begin(lines[0], {at(":1:8: base: "), "gone.toml"});
}

TEST_F(StudyRuns, QuantityMustBeAProbe) {
  const Lines lines =
      mistakes_of(axis("time.step", "[1, 2]") + "[reference]\nset = {}\n[compare]\nquantities = [\"p\"]\n");
  ASSERT_EQ(lines.size(), 1u);
  expect_begin(lines[0], {at(":8:15: compare.quantities[0]: "), "'p'", "base.toml"});
}

}  // namespace
}  // namespace creepcontact::config
