/// The tables at the end of a run say what the summary holds; advice comes where it is due, and only there.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "creepcontact/run/report.hpp"

namespace creepcontact::run {
namespace {

using Lines = std::vector<std::string>;

void expect_text(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << part << "\nin\n" << whole;
}

Summary good_run() {
  Summary run;
  run.has_output = true;
  run.steps.add({.time = 1, .step = 1, .order = 1, .error_estimate = 0.2});
  run.steps.add({.time = 5, .step = 4, .order = 3, .error_estimate = 0.6});
  run.diagnosis = {.bodies = {{"shaft", 20}, {"bolt", 0.5}, {"plate", std::numeric_limits<double>::infinity()}},
                   .contacts = {{"head", 3}, {"nut", 40}}};
  io::Summary& summary = run.results;
  summary.method = "cvode_bdf";
  summary.steps = 100;
  summary.rejected_steps = 2;
  summary.convergence_failures = 1;
  summary.rhs_evaluations = 140;
  summary.jacobian_products = 120;
  summary.elastic_solves = 270;
  summary.contact_solves = 150;
  summary.schwarz_iterations = 450;
  summary.factorizations = 2;
  summary.accuracy.tolerance = 1e-4;
  summary.wall_seconds = {.total = 10, .parts = {0.4, 1, 5, 2, 0.5, 0.4, 0.2, 0.5}};
  summary.peak_memory_mb = 123;
  return run;
}

TEST(RunReport, TellsWhatTheSummaryHolds) {
  const std::string table = details(good_run());
  for (const char* text :
       {"100 of 1 to 4, 2 rejected, 1 iterations failed; cvode_bdf, order up to 3",
        "270: 140 rates, 120 Jacobian products, 10 others (start, outputs, repetitions, tangent); 2 factorisations",
        "3.0 iterations per solve", "requested for the stress: 1e-04", "0.40 of this on average, 0.60 at most",
        "10.00 s: mesh and model 4 %, factors 10 %, solves 50 %, material points 20 %, contact 5 %, time integration 4 "
        "%, "
        "extremes, events and life 2 %, output 5 %",
        "123 MB"})
    expect_text(table, text);
}

TEST(RunReport, HasNoLinesForWhatIsNotThere) {
  Summary run = good_run();
  run.results.schwarz_iterations = 0;
  run.steps = {};
  run.steps.add({.time = 1, .step = 1, .order = 1, .error_estimate = 0});
  const std::string table = details(run);
  EXPECT_EQ(table.find("accuracy"), std::string::npos);
  EXPECT_EQ(table.find("contact  "), std::string::npos);
  EXPECT_EQ(table.find("processes"), std::string::npos);
  run.steps = {};
  EXPECT_EQ(details(run), "");
  run.has_output = false;
  EXPECT_EQ(report(run), "");
}

TEST(RunReport, HasAColumnForEachProcess) {
  Summary run = good_run();
  run.processes = {.names = {"elements", "memory [MB]"}, .values = {{100, 50}, {120, 60}}};
  expect_text(details(run), "    elements                               100         120\n");
  expect_text(details(run), "    memory [MB]                             50          60\n");
}

TEST(RunReport, AnswersFirst) {
  Summary run = good_run();
  io::Summary& summary = run.results;
  summary.bodies["shaft"].von_mises = {.start = 150, .largest = 160, .end = 40};
  summary.contacts["fit"].normal_force = {.start = 1000, .largest = 1000, .end = 250};
  summary.contacts["rim"].normal_force = {.start = 10, .largest = 10, .end = 0};
  summary.contacts["rim"].opened = 3e4;
  summary.life_fraction["shaft"] = {.value = 0.3, .position = {1, 2, 3}};
  const std::string table = report(run);
  expect_text(table, "contact 'fit'             1000        1000         250        25 %");
  expect_text(table, "body 'shaft'           150         160          40        25 %");
  expect_text(table, "contact 'rim' is open from t = 30000 on");
  expect_text(table, "body 'shaft' has used 30 % of its creep life at (1, 2, 3)");
  EXPECT_EQ(table.find("damage"), std::string::npos);
  EXPECT_EQ(table.find("ruptured"), std::string::npos);
  summary.rupture = {.time = 7, .body = "shaft", .damage = {.value = 0.99, .position = {1, 2, 3}}};
  expect_text(report(run), "body 'shaft' ruptured at t = 7 at (1, 2, 3)");
}

TEST(RunReport, WorkIsOneLine) {
  expect_text(report(good_run()),
              "\n  cvode_bdf: 100 steps (relative stress tolerance 1e-04), 270 elastic solves, 450 Schwarz iterations, "
              "10.00 s, 123 MB\n");
  Summary elastic = good_run();
  elastic.results.method = "";
  elastic.steps = {};
  expect_text(report(elastic), "\n  270 elastic solves, 450 Schwarz iterations, 10.00 s, 123 MB\n");
}

TEST(Advice, IsNotGivenWhereAllWentWell) {
  EXPECT_EQ(advice(good_run()), Lines());
}

TEST(Advice, NamesBodyAndContactWhereIterationsFail) {
  Summary run = good_run();
  run.results.convergence_failures = 12;
  const Lines lines = advice(run);
  ASSERT_EQ(lines.size(), 1U);
  expect_text(lines[0], "failed 12 times in 100 steps");
  expect_text(lines[0], "Body 'bolt' creeps fastest (relaxation time 0.5 at the end)");
  expect_text(lines[0], "Contact 'nut' opened or closed somewhere in 40 of 100 steps");
  run.results.steps = 19;  // too few to say
  EXPECT_EQ(advice(run), Lines());
}

TEST(Advice, TellsOfRejectedStepsAndOfContactThatKeepsThemShort) {
  Summary run = good_run();
  run.results.rejected_steps = 35;
  const Lines lines = advice(run);
  ASSERT_EQ(lines.size(), 2U);
  expect_text(lines[0], "time.breakpoints");
  expect_text(lines[1], "contact 'nut' opened or closed");
  run.diagnosis = {};
  EXPECT_EQ(advice(run),
            Lines({lines[0].substr(0, lines[0].find(" Body")) + lines[0].substr(lines[0].find(" If loads"))}));
}

TEST(Advice, TellsOfExpensiveContactSolves) {
  Summary run = good_run();
  run.results.schwarz_iterations = 50 * run.results.contact_solves;
  const Lines lines = advice(run);
  ASSERT_EQ(lines.size(), 1U);
  expect_text(lines[0], "50 iterations per solve");
}

}  // namespace
}  // namespace creepcontact::run
