#include "../../../src/run/gap_report.hpp"

#include <fmt/format.h>

#include <sstream>

#include "creepcontact/run/check.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

std::string check_of(const Case& blocks, const std::vector<std::string>& overrides = {}) {
  std::ostringstream report;
  check(blocks.config("", overrides), report);
  return report.str();
}

/// The upper block is moved along z; its diagonal is 2.449.
Case moved(double z) {
  std::string geometry = separate_blocks();
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"e = 1e-3", "e = 0.05"},
                                 {"Box(2) = {0, 0, 0,", fmt::format("Box(2) = {{0, 0, {},", z)}})
    geometry.replace(geometry.find(from), from.size(), to);
  return Case(geometry);
}

TEST(GapReport, DistancesStandNextToTheGivenGap) {
  const std::string touching = check_of(Case());
  EXPECT_TRUE(says(touching, {", gap 0, ", "mesh 0\n"}));
  EXPECT_FALSE(contains(touching, "warning")) << touching;
  EXPECT_TRUE(says(check_of(moved(0.001)), {", gap 0, ", "mesh 0.001\n"}));
  EXPECT_TRUE(says(check_of(moved(0.04), {"contacts.0.gap=geometric"}), {", gap ", "mesh, 0.04\n"}));
  EXPECT_TRUE(says(check_of(moved(-0.001), {"contacts.0.type=tied"}), {", tied, ", "mesh -0.001\n"}));
}

TEST(GapReport, OverlapThatIsTakenAsTouchingIsWarnedOf) {
  const std::string overlap = check_of(moved(-0.01));
  EXPECT_TRUE(
      says(overlap, {"warning: contact", "overlap", " 0.01 ", "gap", " 0;", "body 'upper' (2.4", "\"geometric\""}));
  EXPECT_TRUE(says(check_of(moved(-0.01), {"contacts.0.type=tied"}),
                   {"warning: contact", "overlap", " 0.01 ", "body 'upper' (2.4", "tied"}));
}

TEST(GapReport, BoundsOfTheWarning) {
  EXPECT_FALSE(contains(check_of(moved(-0.0024)), "warning")) << "less than 2.449e-3";
  EXPECT_TRUE(contains(check_of(moved(-0.0026)), "warning: contact"));
  EXPECT_TRUE(says(check_of(moved(0.04)), {"warning: contact", " 0.04 apart", "gap", " 0;"}));
  EXPECT_FALSE(contains(check_of(moved(0.04), {"contacts.0.gap=0.038+0.001*x"}), "warning"));
  EXPECT_FALSE(contains(check_of(moved(-0.04), {"contacts.0.gap=geometric"}), "warning"));
  EXPECT_FALSE(contains(check_of(Case(), {"contacts.0.gap=-0.05"}), "warning")) << "interference, drawn as touching";
}

}  // namespace
}  // namespace creepcontact::run::test
