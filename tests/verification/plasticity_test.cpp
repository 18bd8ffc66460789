// Rate-independent plasticity next to creep, against closed forms. Unless said otherwise E = 1000, yield stress 1.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "support/says.hpp"
#include "verification/cube.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plasticity_tests {
namespace {

using namespace test;

const double k = 1 / std::numbers::sqrt3;  // yield stress in shear

const std::string inside = "body = \"cube\"\nreduce = \"mean\"";

/// A bar of length 100 under a strain, free to contract.
Outcome run_bar(const std::string& material, const std::string& strain, const std::string& time,
                const std::vector<std::string>& overrides = {}) {
  const std::string toml =
      R"toml(
    [mesh]
    file = "case.geo"
    order = 1
    [bodies.cube]
    region = "cube"
    material = "alloy"
    [materials.alloy]
    young_modulus = 1000
    poisson_ratio = 0.3
  )toml" +
      material + "\n[time]\n" + time + "\n" + probe("stress", "stress_xx", inside) +
      probe("plastic", "plastic_strain_xx", inside) + probe("sideways", "plastic_strain_yy", inside) +
      probe("accumulated", "plastic_strain_equivalent", inside) + probe("strain", "strain_xx", inside) +
      support("x0", "x") + support("y0", "y") + support("z0", "z") + support("x1", "x", strain);
  return run_case(toml, cube_geo, overrides);
}

TEST(PlasticBar, HardensAlongItsTable) {
  const Outcome bar = run_bar("plasticity.curve = { plastic_strain = [0, 0.001, 0.005], stress = [1, 1.2, 1.5] }",
                              R"({ t = [0, 1, 2], values = [0, 0.4, 0] })", "end = 2\noutput = [0.2, 1, 2]");
  EXPECT_NEAR(bar.history.at("stress", 0.2), 0.8, 1e-9);
  EXPECT_NEAR(bar.history.at("stress", 1), 1.325581395, 1e-7);
  EXPECT_NEAR(bar.history.at("plastic", 1), 0.002674418605, 1e-9);
  EXPECT_NEAR(bar.history.at("sideways", 1), -0.5 * 0.002674418605, 1e-9);
  EXPECT_NEAR(bar.history.at("strain", 1), 0.004, 1e-12);
  EXPECT_NEAR(bar.history.at("accumulated", 1), 0.002674418605, 1e-9);
  // Unloading: elastic by 2.651, then flow in compression along the table.
  EXPECT_GT(bar.history.at("accumulated", 2), 0.002674418605 + 1e-6);
  EXPECT_LT(bar.history.at("stress", 2), -1.325);
}

TEST(PlasticBar, YieldsAtTheStartAndThenRelaxes) {
  for (const double H : {0.0, 1000.0 / 99}) {
    const Outcome bar = run_bar(fmt::format("plasticity = {{ yield_stress = 1, hardening_modulus = {} }}\n"
                                            "[[materials.alloy.creep]]\nlaw = \"norton\"\nA = 1e-4\nn = 5\n",
                                            H),
                                "0.4", "end = 1000\noutput = [1, 10, 100]\ntolerance = 1e-5");
    const double plastic = (4 - 1) / (1000 + H), start = 4 - 1000 * plastic;
    EXPECT_NEAR(bar.history.at("plastic", 0), plastic, 1e-8);
    EXPECT_NEAR(bar.history.at("stress", 0), start, 1e-6);
    for (const double t : {1.0, 10.0, 100.0, 1000.0})
      EXPECT_NEAR(bar.history.at("stress", t), std::pow(std::pow(start, -4) + 4e-4 * 1000 * t, -0.25), 1e-4) << t;
    EXPECT_NEAR(bar.history.at("accumulated", 1000), plastic, 1e-8) << "relaxing unloads elastically";
  }
}

TEST(PlasticBar, CyclesBetweenBackStresses) {
  std::string times = "0", values = "0";
  for (int i = 0; i < 30; ++i) {
    times += fmt::format(", {}", 2 * i + 1);
    values += i % 2 == 0 ? ", 0.3" : ", -0.3";
  }
  const Outcome bar = run_bar("plasticity = { yield_stress = 0.7, kinematic = [{ C = 300, gamma = 1000 }] }",
                              fmt::format("{{ t = [{}], values = [{}] }}", times, values), "end = 59\noutput = [57]");
  EXPECT_NEAR(std::abs(bar.history.at("stress", 59)), 0.9894300390, 1e-6);
  EXPECT_NEAR(1000 * (bar.history.at("accumulated", 59) - bar.history.at("accumulated", 57)), 2 * 2.010570, 1e-4);
}

// The limit of the elastic range costs nothing: the same bits with a yield stress that is not reached.
TEST(PlasticBar, ThatStaysElasticHasTheSameBits) {
  const std::string creep = "[[materials.alloy.creep]]\nlaw = \"norton\"\nA = 1e-4\nn = 5\n";
  const std::string time = "end = 1000\noutput = { first = 1, count = 10, spacing = \"log\" }";
  const std::string strain = R"({ t = [0, 1, 50, 1000], values = [0.05, 0.09, 0.02, 0.09] })";
  const Outcome without = run_bar(creep, strain, time),
                with = run_bar("plasticity.yield_stress = 1\n" + creep, strain, time);
  for (const char* name : {"time", "stress", "strain"})
    EXPECT_EQ(with.history.column(name), without.history.column(name)) << name;
  EXPECT_EQ(with.summary.number("steps"), without.summary.number("steps"));
  EXPECT_EQ(with.summary.number("rhs_evaluations"), without.summary.number("rhs_evaluations"));
}

/// Hill's cylinder, b/a = 2, nu near 0.5, both ends held (R. Hill, 1950).
Outcome run_cylinder(const std::string& material, const std::string& pressure, const std::string& time,
                     bool fails = false) {
  const std::string toml = section_of("axisymmetric") + R"toml(
    [bodies.wall]
    region = "wall"
    material = "alloy"
    [materials.alloy]
    young_modulus = 1000
    poisson_ratio = 0.4999
    plasticity = { yield_stress = 1 }
  )toml" + material + "\n[time]\n" +
                           time + "\n[[loads]]\non = \"wall_x0\"\npressure = " + pressure + "\n" +
                           support("wall_y0", "y") + support("wall_y1", "y") +
                           probe("bore", "stress_theta", "at = [1, 0.025, 0]\nbody = \"wall\"") +
                           probe("outside", "displacement_x", "at = [2, 0.025, 0]\nbody = \"wall\"") +
                           probe("flow", "plastic_strain_equivalent", "body = \"wall\"\nreduce = \"max\"");
  const std::string geo = regions_geo({{"wall", {1, 2, 20}, {0, 0.05, 1}}});
  return fails ? run_to_failure(toml, geo) : run_case(toml, geo);
}

/// Radius of the plastic zone under a pressure.
double plastic_radius(double pressure) {
  double low = 1, high = 2;
  for (int i = 0; i < 60; ++i) {
    const double c = 0.5 * (low + high);
    (k * (1 - c * c / 4 + 2 * std::log(c)) < pressure ? low : high) = c;
  }
  return low;
}

TEST(PlasticCylinder, GrowsAsHillSays) {
  const Outcome wall = run_cylinder("", R"({ t = [0, 1], values = [0, 0.79] })", "end = 1\noutput = [0.5, 0.8]");
  for (const double t : {0.5, 0.8, 1.0}) {
    const double p = 0.79 * t;
    const double c = p > 0.433013 ? plastic_radius(p) : 0;
    const double expected = c > 0 ? 1.5 * k * c * c / 2 / 1000 : 1.5 * p / 3 * 2 / 1000;
    EXPECT_RELATIVE(wall.history.at("outside", t), expected, 3e-3);
  }
}

TEST(PlasticCylinder, ResidualStressCreepsAway) {
  const Outcome wall = run_cylinder("[[materials.alloy.creep]]\nlaw = \"norton\"\nA = 3e-4\nn = 5\n",
                                    R"({ t = [0, 1e-6, 2e-6], values = [0, 0.75, 0] })",
                                    "end = 1000\noutput = [2e-6, 1, 10, 100]\ntolerance = 1e-4");
  EXPECT_NEAR(wall.history.at("bore", 2e-6), 2 * k - 8 * 0.75 / 3, 4e-3);
  const std::vector<std::array<double, 3>> published{
      {1, -0.790225, 0.353191}, {10, -0.599970, 0.341232}, {100, -0.371221, 0.314199}, {1000, -0.214415, 0.288268}};
  for (const auto& [t, bore, outside] : published) {
    EXPECT_NEAR(wall.history.at("bore", t), bore, 5e-3) << t;
    EXPECT_NEAR(1000 * wall.history.at("outside", t), outside, 2e-3) << t;
  }
}

TEST(PlasticCylinder, BeyondTheLimitLoadEndsWithItsPressure) {
  const Outcome wall = run_cylinder("", R"({ t = [0, 1], values = [0, 0.9] })", "end = 1\noutput = [0.5, 0.8]", true);
  EXPECT_EQ(wall.exit_status, 4);
  EXPECT_TRUE(says(wall.message, {"cannot be carried", "'wall'", "plastic strain"})) << wall.message;
  EXPECT_NEAR(0.9 * wall.summary.number("time_reached"), 0.80038, 2e-3);
}

}  // namespace
}  // namespace plasticity_tests
}  // namespace creepcontact
