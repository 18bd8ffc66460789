/// Rigid surfaces on bodies that yield: bending of a bar between rigid ends by its closed form, and a block under a
/// rigid plate against the same under a stiff body.

#include <fmt/format.h>

#include <cmath>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_rigid_tests {
namespace {

using namespace test;

/// Perfectly plastic, rectangular section: M = 3/2 M_y (1 - (kappa_y/kappa)^2/3), M_y = sy b h^2/6, kappa_y = 2 sy/(E
/// h).
TEST(PlasticBending, BetweenRigidEndsHasTheCurvatureOfItsMoment) {
  constexpr double modulus = 1000, yield_moment = 1.0 / 6, yield_curvature = 2 / modulus;
  const std::string inside = "body = \"bar\"";
  std::string toml = section_of("plane_stress") + body("bar", modulus, 0.3) + "plasticity = { yield_stress = 1 }\n" +
                     support("bar_x0", "x") + support("foot", "y") +
                     fmt::format(
                         "[[rigid]]\non = \"bar_x1\"\nmoment = [0, 0, {{ t = [0, 1.3, 2.6], values = [0, {0:.15g}, "
                         "0] }}]\n[time]\nend = 2.6\noutput = [0.9, 1.1, 1.2, 1.3]\ntolerance = 1e-5\n",
                         1.3 * yield_moment) +
                     probe("top", "displacement_x", "at = [2, 0.5, 0]\n" + inside) +
                     probe("bottom", "displacement_x", "at = [2, -0.5, 0]\n" + inside) +
                     probe("flow", "plastic_strain_equivalent", "at = [1, 0.49, 0]\n" + inside);
  const Table history =
      run_case(toml, regions_geo({{"bar", {0, 4, 8}, {-0.5, 0.5, 16}}}) + "Physical Point(\"foot\") = {1};\n").history;
  const auto curvature = [&](double t) { return (history.at("bottom", t) - history.at("top", t)) / 2; };
  const auto exact = [&](double m) { return yield_curvature * (m <= 1 ? m : 1 / std::sqrt(3 - 2 * m)); };
  for (const double m : {0.9, 1.1, 1.2, 1.3}) EXPECT_RELATIVE(curvature(m), exact(m), 1e-2);
  EXPECT_RELATIVE(curvature(2.6), exact(1.3) - 1.3 * yield_curvature, 2e-2);
}

/// Pressed sideways and down and turned.
TEST(PlasticBlock, UnderARigidPlateIsThatUnderAStiffBody) {
  const std::string block = body("block", 1000, 0.3) + "plasticity = { yield_stress = 1, hardening_modulus = 20 }\n" +
                            support("block_y0", "x") + support("block_y0", "y") +
                            "[time]\nend = 1\ntolerance = 1e-5\n" + probe("pull", "reaction_x", "on = \"block_y0\"") +
                            probe("press", "reaction_y", "on = \"block_y0\"") +
                            probe("flow", "plastic_strain_equivalent", "body = \"block\"\nreduce = \"mean\"");
  const Region lower{"block", {0, 2, 16}, {0, 1, 8}}, upper{"plate", {0, 2, 16}, {1, 1.5, 2}};
  const Table rigid =
      run_case(
          section_of("plane_strain") + block +
              "[[rigid]]\non = \"block_y1\"\norigin = [0, 1, 0]\ndisplacement = { x = \"0.001*t\", y = \"-0.002*t\" }\n"
              "rotation = { z = \"-0.001*t\" }\n",
          regions_geo({lower}))
          .history;
  const Table stiff =
      run_case(section_of("plane_strain") + block + body("plate", 1e7, 0.3) +
                   "[[supports]]\non = \"plate_y1\"\ndisplacement = { x = \"(0.001 + 0.001*(y - 1))*t\", y = "
                   "\"(-0.002 - 0.001*x)*t\" }\n" +
                   contact_table("block_y1", "plate_y0", "type = \"tied\""),
               regions_geo({lower, upper}))
          .history;
  for (const char* name : {"pull", "press", "flow"})
    EXPECT_RELATIVE(rigid.at(name, 1), stiff.at(name, 1), 1e-3) << name;
  EXPECT_GT(rigid.at("flow", 1), 1e-3);
}

}  // namespace
}  // namespace plastic_rigid_tests
}  // namespace creepcontact
