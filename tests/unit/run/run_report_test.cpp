/// The tables at the end of a run say what the summary holds; advice comes where it is due, and only there.
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "creepcontact/run/report.hpp"
#include "support/says.hpp"

namespace creepcontact::run {
namespace {

using Lines = std::vector<std::string>;

void expect_text(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << part << "\nin\n" << whole;
}

/// A line of the text names all of the facts.
void expect_line(const std::string& whole, std::initializer_list<std::string_view> facts) {
  std::istringstream text(whole);
  for (std::string line; std::getline(text, line);)
    if (creepcontact::test::says(line, facts)) return;
  ADD_FAILURE() << *facts.begin() << "\nin\n" << whole;
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
  expect_line(table, {"steps ", "100", "1 to 4", "2 rejected", " 1 ", "cvode_bdf", " 3"});
  expect_line(table, {"elastic solves ", "270", "140", "120", "10 ", "2 factorisations"});
  expect_line(table, {"contact ", "3.0 iterations"});
  expect_line(table, {"accuracy ", "1e-04", "0.40", "0.60"});
  expect_line(table, {"time ", "10.00 s", "4 %", "10 %", "50 %", "20 %", "5 %", "4 %", "2 %", "5 %"});
  expect_line(table, {"memory ", "123 MB"});
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
  expect_line(table, {"contact 'rim'", "open", "t = 30000"});
  expect_line(table, {"body 'shaft'", "30 %", "(1, 2, 3)"});
  EXPECT_EQ(table.find("damage"), std::string::npos);
  EXPECT_EQ(table.find("ruptured"), std::string::npos);
  summary.rupture = {.time = 7, .body = "shaft", .damage = {.value = 0.99, .position = {1, 2, 3}}};
  expect_line(report(run), {"body 'shaft'", "rupture", "t = 7", "(1, 2, 3)"});
}

TEST(RunReport, WorkIsOneLine) {
  expect_line(report(good_run()), {"cvode_bdf: ", "100 steps", "1e-04", "270 ", "450 ", "10.00 s", "123 MB"});
  Summary elastic = good_run();
  elastic.results.method = "";
  elastic.steps = {};
  expect_line(report(elastic), {"270 ", "450 ", "10.00 s", "123 MB"});
  EXPECT_EQ(report(elastic).find("steps"), std::string::npos);
}

TEST(Advice, IsNotGivenWhereAllWentWell) {
  EXPECT_EQ(advice(good_run()), Lines());
}

TEST(Advice, NamesBodyAndContactWhereIterationsFail) {
  Summary run = good_run();
  run.results.convergence_failures = 12;
  const Lines lines = advice(run);
  ASSERT_EQ(lines.size(), 1U);
  expect_line(lines[0],
              {"12 times", "100 steps", "Body 'bolt'", "0.5", "Contact 'nut'", "40 of 100 steps", "time.integrator"});
  run.results.steps = 19;  // too few to say
  EXPECT_EQ(advice(run), Lines());
}

TEST(Advice, TellsOfRejectedStepsAndOfContactThatKeepsThemShort) {
  Summary run = good_run();
  run.results.rejected_steps = 35;
  const Lines lines = advice(run);
  ASSERT_EQ(lines.size(), 2U);
  expect_line(lines[0], {"35 steps", "100 ", "Body 'bolt'", "Contact 'nut'", "time.breakpoints"});
  expect_line(lines[1], {"contact 'nut'", "40 of 100 steps", "time.tolerance"});
  EXPECT_NE(lines[1].find("coarser mesh"), std::string::npos);
  for (Diagnosis::Contact& contact : run.diagnosis.contacts) contact.is_narrow = true;
  EXPECT_EQ(advice(run)[1].find("coarser mesh"), std::string::npos) << "against the accuracy: " << advice(run)[1];
  run.diagnosis = {};
  const Lines undiagnosed = advice(run);
  ASSERT_EQ(undiagnosed.size(), 1U);
  expect_line(undiagnosed[0], {"35 steps", "100 ", "time.breakpoints"});
  EXPECT_EQ(undiagnosed[0].find('\''), std::string::npos) << "names no body and no contact: " << undiagnosed[0];
}

TEST(Advice, TellsOfExpensiveContactSolves) {
  Summary run = good_run();
  run.results.schwarz_iterations = 50 * run.results.contact_solves;
  const Lines lines = advice(run);
  ASSERT_EQ(lines.size(), 1U);
  expect_line(lines[0], {"50 iterations", "contact_solver.method"});
}

}  // namespace
}  // namespace creepcontact::run
