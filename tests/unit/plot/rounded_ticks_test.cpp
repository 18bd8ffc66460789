// The table is that of web/report/test/check_ticks.mjs too: pictures and pages have the same numbers.
#include "creepcontact/plot/rounded_ticks.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace creepcontact::plot {
namespace {

TEST(RoundedTicks, AreThoseOfTheTable) {
  std::ifstream file(CREEPCONTACT_TICK_TABLE);
  const nlohmann::json table = nlohmann::json::parse(file);
  ASSERT_GT(table.size(), 5U);
  for (const nlohmann::json& row : table) {
    const double low = row["low"], high = row["high"];
    const std::vector<double> expected = row["ticks"], found = rounded_ticks(low, high);
    ASSERT_EQ(found.size(), expected.size()) << row.dump();
    const double range = expected.back() - expected.front();
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12 * range) << row.dump();
  }
}

}  // namespace
}  // namespace creepcontact::plot
