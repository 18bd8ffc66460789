/// Bodies that have a stress before they are loaded: what the supports hold stays, what nothing holds is relieved.

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/model/model.hpp"
#include "support/says.hpp"
#include "verification/cube.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace initial_stress_tests {
namespace {

using namespace test;

const std::string held_end = support("x1", "x");
std::string stressed(const std::string& keys) {
  return "\n[initial_stress.cube]\n" + keys + "\n";
}

/// E A t and the stress of a bar between walls: d sigma/dt = -E A sigma^n.
TEST(InitialStress, RelaxesBetweenWalls) {
  constexpr double start = 150, A = 1e-14, n = 5, end = 1e3;
  const Outcome outcome =
      run_cube(creep_law_table("norton", fmt::format("A = {}\nn = {}", A, n)),
               held_end + stressed(fmt::format("xx = {}", start)), fmt::format("end = {}\ntolerance = 1e-5", end));
  const double exact = std::pow(std::pow(start, 1 - n) + (n - 1) * 200e3 * A * end, 1 / (1 - n));
  ASSERT_LT(exact, 0.9 * start);
  EXPECT_RELATIVE(outcome.history.at("sxx", 0), start, 1e-10);
  EXPECT_NEAR(outcome.history.at("exx", 0), 0, 1e-12);
  EXPECT_RELATIVE(outcome.history.at("sxx", end), exact, 1e-5);
}

TEST(InitialStress, IsRelievedWhereNothingHoldsIt) {
  const Outcome outcome =
      run_cube("", stressed("xx = 150\nxy = 0\nzz = \"30\"") + pulled("20"), "end = 1\nintegrator = \"cvode_adams\"");
  for (const double t : {0.0, 1.0}) {
    EXPECT_NEAR(outcome.history.at("sxx", t), 20, 1e-9);
    EXPECT_NEAR(outcome.history.at("szz", t), 0, 1e-9);
    EXPECT_NEAR(outcome.history.at("exx", t), (20 - 150 + 0.3 * 30) / 200e3, 1e-13);
  }
}

/// Its elastic strain is that of the reference temperature, so that the stress follows Young's modulus.
TEST(InitialStress, FollowsElasticConstantsOverTheTemperature) {
  std::string toml =
      cube_toml("reference_temperature = 20",
                held_end + stressed("xx = 150") + "\n[temperature]\nvalue = \"20 + 480*t\"\n", "end = 1");
  const std::string constant = "young_modulus = 200e3";
  toml.replace(toml.find(constant), constant.size(), "young_modulus = \"200e3 - 100*(T - 20)\"");
  const Outcome outcome = run_case(toml, cube_geo);
  EXPECT_RELATIVE(outcome.history.at("sxx", 0), 150, 1e-10);
  EXPECT_RELATIVE(outcome.history.at("sxx", 1), 150 * 152e3 / 200e3, 1e-10);
}

/// Stress beyond yield is taken back at once.
TEST(InitialStress, YieldsBeforeLoadsAct) {
  const Outcome outcome = run_cube("plasticity = { yield_stress = 100 }", held_end + stressed("xx = 150"), "end = 1");
  EXPECT_RELATIVE(outcome.history.at("sxx", 0), 100, 1e-6);
}

/// A load that takes the initial stress back leaves the body elastic, though it exceeds the yield stress by itself.
TEST(InitialStress, IsThereBeforeLoadsGrow) {
  const std::string end = support("x1", "x", "-0.09");  // -180 by itself
  const Outcome outcome = run_cube("plasticity = { yield_stress = 100 }", end + stressed("xx = 90"), "end = 1");
  EXPECT_RELATIVE(outcome.history.at("sxx", 0), -90, 1e-6);
}

constexpr double inner = 100, outer = 200;

/// sigma_r = A/r^2 + B + C (2 ln r + 1), sigma_theta = -A/r^2 + B + C (2 ln r + 3): in equilibrium, zero on both
/// surfaces (the stress of a ring of which a wedge was taken out: Timoshenko and Goodier, Theory of Elasticity, 31).
struct WeldedRing {
  double A, B, C = 100;
  WeldedRing() {
    const double i = 1 / (inner * inner), o = 1 / (outer * outer);
    A = -C * (2 * std::log(inner) - 2 * std::log(outer)) / (i - o);
    B = -A * i - C * (2 * std::log(inner) + 1);
  }
  std::string radial(const std::string& r2) const {
    return fmt::format("\"{:.17g}/({}) + {:.17g} + {}*(log({}) + 1)\"", A, r2, B, C, r2);
  }
  std::string hoop(const std::string& r2) const {
    return fmt::format("\"{:.17g}/({}) + {:.17g} + {}*(log({}) + 3)\"", -A, r2, B, C, r2);
  }
  double hoop_at(double r) const { return -A / (r * r) + B + C * (2 * std::log(r) + 3); }
};

TEST(InitialStress, InEquilibriumStaysAsItIs) {
  const WeldedRing ring;
  const Region region{"ring", {inner, outer, 24}, {0, std::acos(-1.0) / 2, 24}, true};
  const std::string common = body("ring", 200e3, 0.3) + support("ring_y0", "y") + support("ring_y1", "x") +
                             "[time]\nend = 1\nintegrator = \"cvode_adams\"\n" +
                             probe("hoop", "stress_theta", "at = [150, 0, 0]") +
                             probe("u", "displacement_magnitude", "body = \"ring\"\nreduce = \"max\"");
  // In a section sigma_xx = sigma_r cos^2 + sigma_theta sin^2 ...
  const std::string r2 = "x^2 + y^2";
  const auto strip = [](const std::string& text) { return "(" + text.substr(1, text.size() - 2) + ")"; };
  const std::string r = strip(ring.radial(r2)), h = strip(ring.hoop(r2));
  const std::string in_plane = fmt::format(
      "\n[initial_stress.ring]\nxx = \"({0}*x^2 + {1}*y^2)/({2})\"\nyy = \"({0}*y^2 + {1}*x^2)/({2})\"\n"
      "xy = \"({0} - {1})*x*y/({2})\"\n",
      r, h, r2);
  const Outcome outcome = run_case(section_of("plane_stress") + common + in_plane, regions_geo({region}));
  EXPECT_RELATIVE(outcome.history.at("hoop", 0), ring.hoop_at(150), 2e-3);
  EXPECT_LT(outcome.history.at("u", 0), 1e-3 * 100 / 200e3 * outer);  // of what such a stress would move
}

TEST(InitialStress, AboutAnAxisInASolid) {
  const WeldedRing ring;
  const RingMesh mesh{"ring", inner, outer, 16, 16};
  const std::string r2 = "x^2 + y^2";
  const std::string toml =
      "[mesh]\nfile = \"case.geo\"\n" + body("ring", 200e3, 0.3) + ring_supports({mesh}, false) +
      "[time]\nend = 1\nintegrator = \"cvode_adams\"\n" + probe("hoop", "stress_theta", "at = [150, 0, 0]") +
      probe("u", "displacement_magnitude", "body = \"ring\"\nreduce = \"max\"") +
      fmt::format("\n[initial_stress.ring]\nradial = {}\ntangential = {}\n", ring.radial(r2), ring.hoop(r2));
  const Outcome outcome = run_case(toml, rings_geo({mesh}, 10));
  EXPECT_RELATIVE(outcome.history.at("hoop", 0), ring.hoop_at(150), 4e-3);
  EXPECT_LT(outcome.history.at("u", 0), 2e-3 * 100 / 200e3 * outer);
}

/// A table is exact for a stress that is linear in the place.
TEST(InitialStress, ComesFromATable) {
  std::string table = "X [mm]; Y; Z; S.S11; stress_yy; Szz; sxy; s23; s13\n";
  for (const double x : {0, 100})
    for (const double y : {0, 100})
      for (const double z : {0, 100}) table += fmt::format("{};{};{};{};0;0;0;0;0\n", x, y, z, 50 + x);
  const std::string toml =
      cube_toml("", held_end + stressed("file = \"S.csv\""), "end = 1\nintegrator = \"cvode_adams\"");
  const Outcome outcome = run_case(toml, cube_geo, {}, {{"S.csv", table}});
  EXPECT_RELATIVE(outcome.history.at("sxx", 0), 100, 1e-9);  // their mean, for the bar carries one force
}

TEST(InitialStress, MistakesInATableAreNamed) {
  const auto message = [](const std::string& table) -> std::string {
    const CaseDirectory directory(cube_geo);
    std::ofstream(directory.path() / "S.csv") << table;
    try {
      model::build_model(directory.config(cube_toml("", held_end + stressed("file = \"S.csv\""), "end = 1"), {}));
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_TRUE(
      says(message("x,y,z,xx\n0,0,0,1\n"), {"initial_stress.cube: ", "S.csv", "no column of the stress yy", "zeros"}))
      << message("x,y,z,xx\n0,0,0,1\n");
  EXPECT_TRUE(says(message("x,y,xx,yy,zz,xy,yz,zx\n"), {"S.csv", "no column of z"}));
  EXPECT_TRUE(says(message("x,y,z,xx,s11,yy,zz,xy,yz,zx\n"), {"S.csv", "more than one column of xx"}));
  EXPECT_TRUE(says(message("x,y,z,xx,yy,zz,xy,yz,zx\n"), {"S.csv", "no points"}));
  EXPECT_TRUE(says(message("x,y,z,xx,yy,zz,xy,yz,zx\n0,0,0,a,0,0,0,0,0\n"), {"S.csv:2: ", "'a'"}));
}

}  // namespace
}  // namespace initial_stress_tests
}  // namespace creepcontact
