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
  EXPECT_TRUE(contains(touching, "multipliers, gap 0, distance in the mesh 0\n")) << touching;
  EXPECT_FALSE(contains(touching, "warning")) << touching;
  EXPECT_TRUE(contains(check_of(moved(0.001)), ", gap 0, distance in the mesh 0.001\n"));
  EXPECT_TRUE(contains(check_of(moved(0.04), {"contacts.0.gap=geometric"}), ", gap from the mesh, 0.04\n"));
  EXPECT_TRUE(contains(check_of(moved(-0.001), {"contacts.0.type=tied"}), ", tied, distance in the mesh -0.001\n"));
}

TEST(GapReport, OverlapThatIsTakenAsTouchingIsWarnedOf) {
  const std::string overlap = check_of(moved(-0.01));
  EXPECT_TRUE(contains(overlap, "the surfaces overlap by 0.01 in the mesh, but the gap given there is 0;")) << overlap;
  EXPECT_TRUE(contains(overlap, "thousandth of body 'upper' (2.4")) << overlap;
  EXPECT_TRUE(contains(check_of(moved(-0.01), {"contacts.0.type=tied"}), "but they are tied as if they touched"));
}

TEST(GapReport, BoundsOfTheWarning) {
  EXPECT_FALSE(contains(check_of(moved(-0.0024)), "warning")) << "less than 2.449e-3";
  EXPECT_TRUE(contains(check_of(moved(-0.0026)), "warning: contact"));
  EXPECT_TRUE(contains(check_of(moved(0.04)), "surfaces are 0.04 apart in the mesh, but the gap given there is 0;"));
  EXPECT_FALSE(contains(check_of(moved(0.04), {"contacts.0.gap=0.038+0.001*x"}), "warning"));
  EXPECT_FALSE(contains(check_of(moved(-0.04), {"contacts.0.gap=geometric"}), "warning"));
  EXPECT_FALSE(contains(check_of(Case(), {"contacts.0.gap=-0.05"}), "warning")) << "interference, drawn as touching";
}

}  // namespace
}  // namespace creepcontact::run::test
