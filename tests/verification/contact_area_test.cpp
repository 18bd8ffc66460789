/// The area in contact with friction: nodes count by their state, not by the sign of a multiplier's rounding error.

#include <fmt/format.h>

#include <algorithm>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace contact_area_cases {
namespace {

/// A block that an eccentric load lifts on one side.
test::Table lifted(const std::string& contact, const std::string& solver, bool upper_first) {
  std::string toml = test::section_of("plane_strain", 1);
  const std::string low = test::body("low", 200000, 0.3), up = test::body("up", 200000, 0.3);
  toml += upper_first ? up + low : low + up;
  toml += "[time]\nend = 1\n[contact_solver]\n" + solver;
  toml += test::support("low_y0", "x") + test::support("low_y0", "y");
  toml += "[[loads]]\non = \"up_y1\"\ntraction = [\"1e-3\", \"-10*(1 + 1.3*(x - 2))\", 0]\n";
  toml += test::contact_table("up_y0", "low_y1", contact);
  toml += test::probe("area", "contact_area", "on = \"up_y0\"");
  toml += test::probe("area_of_left", "contact_area", "on = \"up_y0\"\nwhere = \"x < 1\"");
  toml += test::probe("gap", "gap", "on = \"up_y0\"\nreduce = \"max\"");
  for (const char* reduce : {"min", "max"}) {
    toml += test::probe(std::string("pressure_") + reduce, "contact_pressure",
                        fmt::format("on = \"up_y0\"\nreduce = \"{}\"", reduce));
    toml += test::probe(std::string("status_") + reduce, "contact_status",
                        fmt::format("on = \"up_y0\"\nreduce = \"{}\"", reduce));
  }
  return test::run_case(toml, test::regions_geo({{"low", {-1, 5, 13}, {-1, 0, 3}}, {"up", {0, 4, 11}, {0, 1, 4}}}))
      .history;
}

TEST(ContactAreaWithFriction, CountsNodesByTheirState) {
  const test::Table expected = lifted("friction = 0.3", "friction = \"tresca\"\n", false);
  ASSERT_GT(expected.at("gap", 1), 1e-5);
  ASSERT_LT(expected.at("area", 1), 2);
  for (const bool upper_first : {false, true}) {
    const test::Table found = lifted("friction = 0.3", "friction = \"newton\"\n", upper_first);
    EXPECT_RELATIVE(found.at("area", 1), expected.at("area", 1), 1e-6);
    EXPECT_EQ(found.at("area_of_left", 1), 0);
    EXPECT_EQ(found.at("pressure_min", 1), 0);
    EXPECT_EQ(found.at("status_min", 1), 0);
    EXPECT_GT(found.at("status_max", 1), 0);
    EXPECT_RELATIVE(found.at("pressure_max", 1), expected.at("pressure_max", 1), 1e-6);
  }
  const test::Table smooth = lifted("", "", false);
  EXPECT_NEAR(smooth.at("area", 1), expected.at("area", 1), 0.1);
  EXPECT_EQ(smooth.at("status_min", 1), 0);
}

}  // namespace
}  // namespace contact_area_cases
}  // namespace creepcontact
