/// Errors against references, orders, and the tables of a study, all of made-up runs.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../../../src/study/study_errors.hpp"
#include "../../../src/study/study_plots.hpp"
#include "../../../src/study/study_report.hpp"
#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::study {
namespace {

using config::ErrorNorm;

io::CsvTable history(const std::vector<double>& times, const std::vector<double>& values) {
  return {{"time", "q"}, {times, values}};
}

const std::vector<config::Reference> q{{"q"}};

TEST(StudyErrors, LargestDifferenceOverLargestMagnitude) {
  const ReferenceHistory reference(history({0, 1, 2}, {-8, 4, 2}), "reference", q);
  const auto run = history({0, 0.5, 1, 2}, {-8, 100, 5, 2.5});
  EXPECT_DOUBLE_EQ(reference.error(run, "q", ErrorNorm::max, true).value, 1.0 / 8);
  EXPECT_DOUBLE_EQ(reference.error(run, "q", ErrorNorm::final, true).value, 0.25);
}

TEST(StudyErrors, ClosedFormAtTheTimesOfTheRun) {
  const ReferenceHistory reference({{"q", Function::expression("10 - t", {"t"})}});
  const auto run = history({0, 2, 5}, {10, 9, 5});
  EXPECT_DOUBLE_EQ(reference.error(run, "q", ErrorNorm::max, true).value, 0.1);
  EXPECT_DOUBLE_EQ(reference.error(run, "q", ErrorNorm::final, true).value, 0);
}

TEST(StudyErrors, AWholeRunHasEveryTimeOfTheReference) {
  const ReferenceHistory reference(history({0, 1, 2}, {1, 2, 3}), "reference", q);
  const auto error = reference.error(history({0, 2}, {1, 3}), "q", ErrorNorm::max, true);
  EXPECT_TRUE(std::isnan(error.value));
  EXPECT_TRUE(creepcontact::test::says(error.message, {"t = 1", "reference"}));
}

TEST(StudyErrors, ARupturedRunIsComparedUpToItsEnd) {
  const ReferenceHistory reference(history({0, 1, 2}, {1, 2, 4}), "reference", q);
  const auto run = history({0, 1, 1.5}, {1, 3, 70});
  EXPECT_DOUBLE_EQ(reference.error(run, "q", ErrorNorm::max, false).value, 0.25);
  EXPECT_TRUE(std::isnan(reference.error(run, "q", ErrorNorm::final, false).value));
}

TEST(StudyErrors, NothingIsRelativeToZero) {
  const ReferenceHistory reference(history({0, 1}, {0, 0}), "reference", q);
  const auto error = reference.error(history({0, 1}, {0, 1}), "q", ErrorNorm::max, true);
  EXPECT_TRUE(std::isnan(error.value));
  EXPECT_TRUE(creepcontact::test::says(error.message, {"reference", "'q'", "zero"}));
}

TEST(StudyErrors, MissingColumnsAreNamed) {
  try {
    ReferenceHistory(history({0}, {1}), "ref.csv", {{"p"}, {"q"}, {"r"}});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"ref.csv: ", "column 'p', 'r'", "time, q"}));
  }
}

TEST(StudyOrders, SlopesBetweenConsecutiveValues) {
  const std::vector<double> orders = observed_orders({8, 4, 2, 1}, {64, 16, 0, 1});
  ASSERT_EQ(orders.size(), 3u);
  EXPECT_DOUBLE_EQ(orders[0], 2);
  EXPECT_TRUE(std::isnan(orders[1]));
  EXPECT_TRUE(std::isnan(orders[2]));
}

class StudyTables : public testing::Test {
 protected:
  /// Errors of first order for u, of second for v; the single run fails.
  void SetUp() override {
    for (const config::PlannedRun& run : runs_) {
      StudyRow row;
      row.status = "failed";
      row.message = "gave up, \"really\"";
      row.errors = {std::nan("")};
      if (run.product == 0) {
        const double step = run.point[1] == 0 ? 0.4 : 0.1;
        row.status = "completed";
        row.message.clear();
        row.errors = {run.point[0] == 0 ? step : step * step};
        row.steps = 5;
        row.elastic_solves = 6;
        row.schwarz_iterations = 7;
        row.rejected_steps = 2;
        row.convergence_failures = 1;
        row.wall_seconds = 0.5;
        row.counted = true;
      }
      rows_.push_back(row);
    }
  }

  config::Study study_ = config::parse_study(R"(
title = "cost"
base = "case.toml"
[[axes]]
key = "time.integrator"
values = ["u", "v"]
[[axes]]
key = "time.step"
values = [0.4, 0.1]
[[runs]]
set = { "time.beta" = 0.5, "time.integrator" = "w" }
[reference]
csv = "known.csv"
[compare]
quantities = ["q"]
)",
                                             "study.toml");
  std::vector<config::PlannedRun> runs_ = config::plan(study_);
  std::vector<StudyRow> rows_;
};

TEST_F(StudyTables, CurvesAlongNumbers) {
  const std::vector<StudySeries> all = series(study_, runs_);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].axis, "time.step");
  EXPECT_EQ(all[0].label, "u");
  EXPECT_EQ(all[1].label, "v");
  EXPECT_EQ(all[1].x, (std::vector<double>{0.4, 0.1}));
  EXPECT_EQ(all[1].counts(rows_, "elastic_solves"), (std::vector<double>{6, 6}));
  EXPECT_DOUBLE_EQ(observed_orders(all[0].x, all[0].errors(rows_, 0))[0], 1);
  EXPECT_DOUBLE_EQ(observed_orders(all[1].x, all[1].errors(rows_, 0))[0], 2);
  EXPECT_EQ(all[2].axis, "");
  EXPECT_EQ(all[2].label, "beta = 0.5, w");
  EXPECT_EQ(all[2].runs, std::vector<std::size_t>{4});
  EXPECT_TRUE(std::isnan(all[2].counts(rows_, "steps")[0]));  // it failed
}

TEST_F(StudyTables, ZippedAxesMakeOneCurve) {
  study_.axes[0].zip = study_.axes[1].zip = "z";
  const std::vector<StudySeries> all = series(study_, config::plan(study_));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].label, "as the base");
  EXPECT_EQ(all[0].x, (std::vector<double>{0.4, 0.1}));
  EXPECT_EQ(all[0].runs, (std::vector<std::size_t>{0, 1}));
}

TEST_F(StudyTables, RunsWithAxesOfTheirOwnAreCurvesByTheirLabel) {
  study_.runs[0].axes = {{{"time.tolerance"}, "", {{"1e-2", "1e-2", {}}, {"1e-3", "1e-3", {}}}, {}}};
  study_.runs[0].label = "third";
  const auto runs = config::plan(study_);
  const std::vector<StudySeries> all = series(study_, runs);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[2].axis, "time.tolerance");
  EXPECT_EQ(all[2].label, "third");
  EXPECT_EQ(all[2].x, (std::vector<double>{1e-2, 1e-3}));
  study_.plot.over = {{"time.integrator"}};  // words: no axis of a curve
  EXPECT_EQ(series(study_, runs)[2].axis, "time.tolerance");
  study_.plot.over = {{"time.tolerance"}, {"time.step"}};
  EXPECT_EQ(series(study_, runs)[0].axis, "time.step");
}

TEST_F(StudyTables, NoTwoCurvesHaveOneName) {
  config::Axis copper = study_.axes[0], steel = study_.axes[0];
  copper.key.name = "materials.copper.n";
  steel.key.name = "materials.steel.n";
  copper.values = steel.values = {{"3", "3", {}}};
  study_.runs = {{"", {}, {copper, steel}, {}}, {"w", {}, {}, {}}, {"w", {}, {}, {}}};
  const std::vector<StudySeries> all = series(study_, config::plan(study_));
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[2].label, "materials.copper.n = 3, materials.steel.n = 3");
  EXPECT_EQ(all[3].label, "w");
  EXPECT_EQ(all[4].label, "w (2)");
}

TEST_F(StudyTables, PicturesOfErrorsAndCounts) {
  const io::test::TemporaryDirectory directory;
  study_.plot.show = {"schwarz_iterations"};
  std::vector<std::string> names;
  for (const auto& picture : plot_study(study_, runs_, rows_, directory.path()))
    names.push_back(picture.filename().string());
  EXPECT_EQ(names,
            (std::vector<std::string>{"error_q_over_time_step.svg", "error_q_over_elastic_solves.svg",
                                      "error_q_over_wall_seconds.svg", "schwarz_iterations_over_time_step.svg"}));
  const std::string steps = io::test::read_text(directory / "error_q_over_time_step.gp");
  EXPECT_TRUE(io::test::contains(steps, "set logscale x") && io::test::contains(steps, "'relative error of q'"))
      << steps;
  EXPECT_TRUE(io::test::contains(steps, "title 'u'") && io::test::contains(steps, "title 'v'")) << steps;
  EXPECT_FALSE(io::test::contains(steps, "'beta = 0.5, w'")) << steps;
}

TEST_F(StudyTables, Csv) {
  const std::string text = study_csv(study_, runs_, rows_);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "time.integrator,time.step,time.beta,error_q,q_start,q_end,q_min,q_max,status,message,steps,elastic_solves,"
            "schwarz_iterations,wall_seconds,rejected_steps,convergence_failures");
  EXPECT_NE(text.find("\nu,0.4,,0.4,,,,,completed,,5,6,7,0.5,2,1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nw,,0.5,,,,,,failed,\"gave up, \"\"really\"\"\",,,,,,\n"), std::string::npos) << text;
}

TEST_F(StudyTables, WithoutReferenceTheProbesAreCompared) {
  study_.reference.reset();
  for (StudyRow& row : rows_) {
    row.errors.clear();
    if (row.succeeded()) row.courses = {course_of({3, 1, 4, 1.234567891})};
  }
  const std::string csv = study_csv(study_, runs_, rows_);
  EXPECT_EQ(csv.substr(0, csv.find(",status")), "time.integrator,time.step,time.beta,q_start,q_end,q_min,q_max");
  EXPECT_NE(csv.find("\nu,0.4,,3,1.234567891,1,4,completed,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nw,,0.5,,,,,failed,"), std::string::npos) << csv;
  const std::string markdown = study_markdown(study_, runs_, rows_, {}, "", {});
  EXPECT_NE(markdown.find("| 3 | 1.2346 | 1 | 4 | completed |"), std::string::npos) << markdown;
  EXPECT_EQ(markdown.find("order"), std::string::npos) << markdown;
  const io::test::TemporaryDirectory directory;
  const auto pictures = plot_study(study_, runs_, rows_, directory.path());
  ASSERT_EQ(pictures.size(), 1u) << "and no histories, since no run has one here";
  EXPECT_EQ(pictures.front().filename(), "q_end_over_time_step.svg");
}

TEST_F(StudyTables, CoursesLeaveOutWhatIsNotFinite) {
  const ProbeCourse course = course_of({std::nan(""), 2, 5, 3});
  EXPECT_TRUE(std::isnan(course.start));
  EXPECT_EQ((std::array{course.end, course.min, course.max}), (std::array{3.0, 2.0, 5.0}));
}

TEST_F(StudyTables, EveryRunHasANameOfItsOwn) {
  const std::vector<std::string> labels = run_labels(study_, runs_);
  EXPECT_EQ(labels.front(), "u, step = 0.4");
  EXPECT_EQ(std::set(labels.begin(), labels.end()).size(), runs_.size());
}

TEST_F(StudyTables, Markdown) {
  const std::string text = study_markdown(study_, runs_, rows_, {}, "", {"dir/a.svg"});
  EXPECT_EQ(text.substr(0, 7), "# cost\n");
  EXPECT_NE(text.find("Reference: `known.csv`."), std::string::npos);
  EXPECT_NE(text.find("| u | q | time.step: 0.4 to 0.1 | 1.00 |"), std::string::npos) << text;
  EXPECT_NE(text.find("![a](a.svg)"), std::string::npos) << text;
  EXPECT_NE(text.find("| v | q | time.step: 0.4 to 0.1 | 2.00 |"), std::string::npos) << text;
}

TEST_F(StudyTables, QuantitiesAlikeInLettersHavePicturesOfTheirOwn) {
  const io::test::TemporaryDirectory directory;
  study_.compare.quantities = {{"a 1"}, {"a_1"}};
  for (StudyRow& row : rows_) row.errors.push_back(row.errors[0]);
  const auto pictures = plot_study(study_, runs_, rows_, directory.path());
  EXPECT_EQ(pictures.size(), 6u);
  EXPECT_EQ(std::set(pictures.begin(), pictures.end()).size(), 6u);
}

}  // namespace
}  // namespace creepcontact::study
