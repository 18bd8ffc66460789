// Rate-independent plasticity next to creep, against closed forms. Unless said otherwise E = 1000, yield stress 1.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "support/says.hpp"
#include "verification/interrupted.hpp"
#include "verification/plane_regions.hpp"
#include "verification/plastic_models.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plasticity_tests {
namespace {

using namespace test;

const double k = 1 / std::numbers::sqrt3;  // yield stress in shear

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

Outcome run_cylinder(const std::string& material, const std::string& pressure, const std::string& time,
                     bool fails = false) {
  const std::string toml = cylinder_toml(material, pressure, time);
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

// Bolts tightened beyond yield: the preload is met, flow is that of the hardening, and what follows is creep.
TEST(PlasticJoint, PreloadByForceIsMetBeyondYield) {
  const std::string geo =
      boxes_geo({{"low", {0, 0, 0}, {10, 10, 10}, {2, 2, 2}}, {"up", {0, 0, 10}, {10, 10, 10}, {2, 2, 2}}});
  const std::string supports = support("low_z0", "z") + support("low_x0", "x") + support("low_y0", "y") +
                               support("up_x0", "x") + support("up_y0", "y") + support("up_z1", "z");
  for (const double friction : {0.0, 0.2}) {
    const Outcome joint = run_case(
        "[mesh]\nfile = \"case.geo\"\n[bodies]\nlow = { region = \"low\", material = \"soft\" }\n"
        "up = { region = \"up\", material = \"hard\" }\n"
        "[materials.hard]\nyoung_modulus = 2e5\npoisson_ratio = 0.3\n"
        "[materials.soft]\nyoung_modulus = 2e5\npoisson_ratio = 0.3\nyield_strength = 300\n"
        "plasticity = { yield_stress = 300, hardening_modulus = 2000 }\n"
        "creep = [{ law = \"norton\", A = 1e-16, n = 5 }]\n[time]\nend = 1000\n" +
            fmt::format("[[contacts]]\nname = \"joint\"\nbetween = [\"low_z1\", \"up_z0\"]\nfriction = {}\n"
                        "preload = {{ force = 33000 }}\n",
                        friction) +
            supports + probe("flow", "plastic_strain_equivalent", "body = \"low\"\nreduce = \"mean\""),
        geo);
    EXPECT_RELATIVE(joint.summary.number("contacts/joint/initial_normal_force"), 33000, 1e-5);
    EXPECT_LT(joint.summary.number("contacts/joint/final_normal_force"), 10000);
    EXPECT_NEAR(joint.history.at("flow", 1000), joint.history.at("flow", 0), 1e-9) << "relaxing unloads elastically";
    if (friction == 0) {
      EXPECT_NEAR(joint.history.at("flow", 0), 30.0 / 2000, 1e-7);
      EXPECT_RELATIVE(joint.summary.number("bodies/low/initial_yield_share"), 1.1, 1e-6);
    }
  }
}

/// E times the change of the axial strain in the last of six cycles.
double strip_growth(double primary, double thermal) {
  const Outcome strip = run_strip(primary, thermal, "end = 6\noutput = [1, 2, 3, 4, 5]");
  return 1000 * (strip.history.at("strain", 6) - strip.history.at("strain", 5));
}

TEST(PlasticStrip, ShakesDownOrRatchetsAsBreeSays) {
  EXPECT_NEAR(strip_growth(0.4, 0.5), 0, 1e-9) << "elastic";
  EXPECT_NEAR(strip_growth(0.5, 1.2), 0, 1e-9) << "shakedown";
  EXPECT_NEAR(strip_growth(0.2, 3), 0, 1e-6) << "reverse plasticity";
  EXPECT_RELATIVE(strip_growth(0.7, 1.25), 2 * 1.25 * (1 - 2 * std::sqrt(0.3 / 1.25)), 1e-2);
  EXPECT_RELATIVE(strip_growth(0.3, 4), 2 * (0.3 * 4 - 1), 1e-2);
}

// The elements do not lock, and curved ones with inner displacements flow as the others.
TEST(PlasticCylinder, IsTheSameInAllAnalysesAndElements) {
  struct Mesh {
    std::string analysis;
    bool triangles;
  };
  for (const Mesh& mesh : {Mesh{"plane_strain", false}, Mesh{"plane_strain", true}}) {
    const std::string toml = section_of(mesh.analysis) + wall_of_alloy + R"toml(
      [[loads]]
      on = "wall_x0"
      pressure = { t = [0, 1], values = [0, 0.75] }
      [time]
      end = 1
    )toml" + support("wall_y0", "y") +
                             support("wall_y1", "x") +
                             probe("outside", "displacement_x", "at = [2, 0, 0]\nbody = \"wall\"");
    const Outcome wall =
        run_case(toml, regions_geo({{"wall", {1, 2, 12}, {0, std::numbers::pi / 2, 12}, true, mesh.triangles}}));
    const double c = plastic_radius(0.75);
    EXPECT_RELATIVE(wall.history.at("outside", 1), 1.5 * k * c * c / 2 / 1000, 5e-3) << mesh.triangles;
  }
}

// The same way in half the steps tells how far off the flow is; on a straight path it is exact.
TEST(PlasticRun, EstimatesTheErrorOfItsFlow) {
  const std::string straight = R"({ t = [0, 1], values = [0, 0.4] })";
  const Outcome bar = run_bar("plasticity = { yield_stress = 1, hardening_modulus = 50 }", straight, "end = 1");
  EXPECT_LT(bar.summary.number("plastic_error"), 1e-6);
  // Compressible: the axial stress comes into play as the zone grows, and the stress turns.
  std::string compressible = cylinder_toml("", R"({ t = [0, 1], values = [0, 0.75] })", "end = 1");
  compressible.replace(compressible.find("0.4999"), 6, "0.3");
  const Outcome wall = run_case(compressible, regions_geo({{"wall", {1, 2, 20}, {0, 0.05, 1}}}));
  EXPECT_GT(wall.summary.number("plastic_error"), 1e-5);
  EXPECT_LT(wall.summary.number("plastic_error"), 2e-2);
}

// log_adams continues exactly; the others within the tolerance.
TEST(PlasticRun, IsTheSameWhenResumed) {
  const CaseDirectory directory(regions_geo({{"wall", {1, 2, 8}, {0, 0.05, 1}}}));
  const std::string creep = "creep = [{ law = \"norton\", A = 3e-4, n = 5 }]\n";
  for (const std::string& law : {creep, std::string()}) {
    const config::Config config =
        directory.config(cylinder_toml(law, R"({ t = [0, 1, 5, 6], values = [0, 0.75, 0.75, 0.2] })",
                                       "end = 8\noutput = [0.5, 1, 2, 5, 5.5, 7]"),
                         {"time.integrator=log_adams"});
    std::filesystem::remove_all(directory.path() / "whole");
    std::filesystem::remove_all(directory.path() / "parts");
    expect_same_when_resumed(config, directory.path(), {0.7, 3, 5.2});
  }
}

}  // namespace
}  // namespace plasticity_tests
}  // namespace creepcontact
