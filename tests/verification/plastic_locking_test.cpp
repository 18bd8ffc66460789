/// A thick cylinder, b/a = 2, nearly incompressible, whose bore is widened far beyond yielding: the pressure tends to
/// 2 k ln 2, k = sy/sqrt 3 (R. Hill, The Mathematical Theory of Plasticity, 1950), and does not rise beyond it where
/// elements do not lock.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_locking_tests {
namespace {

using namespace test;

struct Mesh {
  std::string name;
  int order;
  bool triangles;
  int around;  ///< elements on the quarter of a circle: straight ones must be many
};

class PlasticLimit : public testing::TestWithParam<Mesh> {};

/// The pressure is the tension across the section y = 0, from a = 1 to b = 2.
TEST_P(PlasticLimit, IsNotExceeded) {
  const double k = 1 / std::numbers::sqrt3, yields = 1.5 * k / 1000, limit = 2 * k * std::numbers::ln2;
  const Mesh& mesh = GetParam();
  const std::string toml =
      section_of("plane_strain", mesh.order) + body("wall", 1000, 0.4999) + "plasticity = { yield_stress = 1 }\n" +
      fmt::format(
          "[time]\nend = 15\noutput = [5, 10]\n[[supports]]\non = \"wall_x0\"\ndisplacement = {{ normal = {{ t = "
          "[0, 15], values = [0, {:.15g}] }} }}\n",
          -15 * yields) +
      support("wall_y0", "y") + support("wall_y1", "x") + probe("pull", "reaction_y", "on = \"wall_y0\"");
  const double quarter = std::numbers::pi / 2;
  const Table history =
      run_case(toml, regions_geo({{"wall", {1, 2, 12}, {0, quarter, mesh.around}, true, mesh.triangles}})).history;
  for (const double t : {10.0, 15.0}) EXPECT_RELATIVE(-history.at("pull", t), limit, 1e-3);
  EXPECT_NEAR(history.at("pull", 15), history.at("pull", 10), 2e-4) << "it has come to rest";
}

INSTANTIATE_TEST_SUITE_P(Elements, PlasticLimit,
                         testing::Values(Mesh{"quad4", 1, false, 24}, Mesh{"quad8", 2, false, 8},
                                         Mesh{"tri6", 2, true, 8}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace plastic_locking_tests
}  // namespace creepcontact
