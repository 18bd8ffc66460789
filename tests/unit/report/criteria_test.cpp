/// Criteria say in words whether they are met.

#include "../../../src/report/criteria.hpp"

#include <gtest/gtest.h>

namespace creepcontact::report {
namespace {

bool has(const Html& page, const std::string& part) {
  return page.text().find(part) != std::string::npos;
}

RunData run_with(std::map<std::string, io::Summary::Criterion> criteria) {
  RunData run;
  run.summary.emplace();
  run.summary->units = "mm, N, MPa, h";
  run.summary->criteria = std::move(criteria);
  return run;
}

TEST(Criteria, MetMissedAndNotJudged) {
  const RunData run =
      run_with({{"seal",
                 {.met = false,
                  .is_minimum = true,
                  .found = 11.2,
                  .allowed = 12,
                  .utilisation = 12 / 11.2,
                  .time = 1e5,
                  .body = "flange",
                  .position = {{1, 2, 3}},
                  .demand = "seal, at least 12 MPa",
                  .unit = "MPa"}},
                {"stress", {.met = true, .found = 93, .allowed = 100, .utilisation = 0.93, .unit = "MPa"}},
                {"later", {}}});
  Html page;
  add_criteria(run, page);
  for (const char* part :
       {"1 of 3 criteria are met. NOT met: seal. Not judged", ">NOT met</td>", ">met</td>", ">not judged</td>",
        "≥\u00A012\u00A0MPa", "≤\u00A0100\u00A0MPa", ">93\u00A0%</td>", "flange (1, 2, 3)\u00A0mm", "100\u202F000"})
    EXPECT_TRUE(has(page, part)) << part << '\n' << page.text();
}

TEST(Criteria, WhatIsBeyondNeverShowsAsAllowed) {
  EXPECT_EQ(utilisation({.met = false, .utilisation = 1.0004}), "100.1\u00A0%");
  EXPECT_EQ(utilisation({.met = true, .utilisation = 0.9999}), "99.9\u00A0%");
  EXPECT_EQ(utilisation({.met = false, .is_minimum = true, .found = 0, .allowed = 5}), "∞");
  EXPECT_EQ(utilisation({}), "-");
}

TEST(Criteria, NamesAreText) {
  Html page;
  add_criteria(run_with({{"<script>", {.met = true, .body = "<b>", .demand = "a < b", .unit = "<i>"}}}), page);
  for (const char* tag : {"<script", "<b>", "<i>"}) EXPECT_FALSE(has(page, tag));
  EXPECT_TRUE(has(page, "&lt;script&gt;"));
}

TEST(Criteria, NothingWithoutThem) {
  Html page;
  add_criteria(run_with({}), page);
  EXPECT_EQ(page.text(), "");
}

}  // namespace
}  // namespace creepcontact::report
