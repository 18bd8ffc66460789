/// The table at the end of a run says what the summary holds; advice comes where it is due, and only there.
#include "../../../src/run/run_report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace creepcontact::run {
namespace {

using Lines = std::vector<std::string>;

void expect_text(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << part << "\nin\n" << whole;
}

io::Summary good_summary() {
  io::Summary summary;
  summary.steps = 100;
  summary.rejected_steps = 2;
  summary.convergence_failures = 1;
  summary.rhs_evaluations = 140;
  summary.jacobian_products = 120;
  summary.elastic_solves = 270;
  summary.contact_solves = 150;
  summary.schwarz_iterations = 450;
  summary.factorizations = 2;
  summary.wall_seconds = {.total = 10, .factorize = 1, .solve = 5, .material = 2, .contact = 0.5, .output = 0.5};
  summary.peak_memory_mb = 123;
  return summary;
}

StepStatistics steps() {
  StepStatistics statistics;
  statistics.see({.time = 1, .step = 1, .order = 1, .error_estimate = 0.2});
  statistics.see({.time = 5, .step = 4, .order = 3, .error_estimate = 0.6});
  return statistics;
}

Suspects suspects() {
  return {.bodies = {{"shaft", 20}, {"bolt", 0.5}, {"plate", std::numeric_limits<double>::infinity()}},
          .contacts = {{"head", 3}, {"nut", 40}}};
}

TEST(RunReport, TellsWhatTheSummaryHolds) {
  const std::string table = run_table(good_summary(), steps(), 1e-4, "cvode_bdf");
  for (const char* text :
       {"100 of 1 to 4, 2 rejected, 1 iterations failed; cvode_bdf, order up to 3",
        "270: 140 rates, 120 Jacobian products, 10 others (start, outputs, tangent); 2 factorisations",
        "3.0 iterations a solve", "1e-04 requested", "0.40 of what that allows on average, 0.60 at most",
        "10.00 s: factors 10 %, solves 50 %, material points 20 %, contact 5 %, output 5 %", "the rest 10 %", "123 MB"})
    expect_text(table, text);
}

TEST(RunReport, HasNoLinesForWhatIsNotThere) {
  io::Summary summary = good_summary();
  summary.schwarz_iterations = 0;
  StepStatistics plain;
  plain.see({.time = 1, .step = 1, .order = 1, .error_estimate = 0});
  const std::string table = run_table(summary, plain, 1e-4, "explicit_euler");
  EXPECT_EQ(table.find("accuracy"), std::string::npos);
  EXPECT_EQ(table.find("contact  "), std::string::npos);
}

TEST(Advice, IsNotGivenWhereAllWentWell) {
  EXPECT_EQ(advice(good_summary(), steps(), suspects()), Lines());
}

TEST(Advice, NamesBodyAndContactWhereIterationsFail) {
  io::Summary summary = good_summary();
  summary.convergence_failures = 12;
  const Lines lines = advice(summary, steps(), suspects());
  ASSERT_EQ(lines.size(), 1U);
  expect_text(lines[0], "failed 12 times in 100 steps");
  expect_text(lines[0], "Body 'bolt' creeps fastest (relaxation time 0.5 at the end)");
  expect_text(lines[0], "Contact 'nut' opened or closed somewhere in 40 of 100 steps");
  summary.steps = 19;  // too few to say
  EXPECT_EQ(advice(summary, steps(), suspects()), Lines());
}

TEST(Advice, TellsOfRejectedStepsAndOfContactThatKeepsThemShort) {
  io::Summary summary = good_summary();
  summary.rejected_steps = 35;
  const Lines lines = advice(summary, steps(), suspects());
  ASSERT_EQ(lines.size(), 2U);
  expect_text(lines[0], "time.breakpoints");
  expect_text(lines[1], "contact 'nut' opened or closed");
  EXPECT_EQ(advice(summary, steps(), {}),
            Lines({lines[0].substr(0, lines[0].find(" Body")) + lines[0].substr(lines[0].find(" If loads"))}));
}

TEST(Advice, TellsOfDearContactSolves) {
  io::Summary summary = good_summary();
  summary.schwarz_iterations = 50 * summary.contact_solves;
  const Lines lines = advice(summary, steps(), suspects());
  ASSERT_EQ(lines.size(), 1U);
  expect_text(lines[0], "50 iterations a solve");
}

}  // namespace
}  // namespace creepcontact::run
