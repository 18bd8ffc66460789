/// Thick cylinder under internal pressure (NAFEMS R0027, test 7): Lame at the start, the steady state at the end.

#include <fmt/format.h>

#include "verification/case.hpp"
#include "verification/reference/thick_cylinder.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace {

using test::Outcome;

constexpr reference::ThickCylinder exact{100, 200, 200};
const std::vector<double> radii{100, 125, 150, 175, 200};

/// @param time  table of the [time] section
Outcome run_cylinder(const test::RingMesh& mesh, int order, const std::string& time) {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = " + std::to_string(order) + "\n" +
                     test::body("pipe", 200e3, 0.3, 3.125e-14, 5) + test::ring_supports({mesh}, true) +
                     "[[loads]]\non = \"pipe_inner\"\npressure = 200\n" + time;
  for (const double r : radii) {
    const std::string position = fmt::format("at = [{}, 0, 2.5]", r);
    toml += test::probe(fmt::format("theta{}", r), "stress_theta", position);
    toml += test::probe(fmt::format("z{}", r), "stress_zz", position);
    toml += test::probe(fmt::format("r{}", r), "stress_r", position);
  }
  toml += test::probe("expansion", "displacement_x", "at = [200, 0, 2.5]");
  return test::run_case(toml, test::rings_geo({mesh}, 5));
}

TEST(ThickCylinder, ReachesTheSteadyState) {
  const Outcome outcome = run_cylinder({"pipe", 100, 200, 16, 18, 1.03}, 2, "[time]\nend = 200\ntolerance = 1e-5\n");
  const test::Table& history = outcome.history;
  for (const double r : radii) {
    const bool wall = r == 100 || r == 200;
    EXPECT_RELATIVE(history.at(fmt::format("theta{}", r), 0), exact.elastic_sigma_theta(r), wall ? 3e-3 : 1e-3);
    EXPECT_RELATIVE(history.at(fmt::format("theta{}", r), 200), exact.steady_sigma_theta(r, 5), wall ? 3e-3 : 1e-3);
    EXPECT_RELATIVE(history.at(fmt::format("z{}", r), 200), exact.steady_sigma_z(r, 5), wall ? 1e-2 : 1e-3);
    EXPECT_NEAR(history.at(fmt::format("r{}", r), 200), exact.steady_sigma_r(r, 5), 200 * (wall ? 3e-3 : 1e-3));
  }
  EXPECT_RELATIVE(history.at("theta100", 200), 130.39, 3e-3);
  EXPECT_RELATIVE(history.at("theta200", 200), 250.39, 3e-3);
  EXPECT_RELATIVE(history.at("expansion", 0), exact.elastic_displacement(200, 200e3, 0.3), 1e-3);
}

// Linear hexahedra with B-bar: the bore stress at any creep time within 1 % of what quadratic ones give.
TEST(ThickCylinder, LinearHexahedraDoNotLock) {
  const std::string time = "[time]\nend = 200\ntolerance = 1e-4\noutput = [0.01, 0.1, 1, 10, 200]\n";
  const Outcome fine = run_cylinder({"pipe", 100, 200, 16, 18, 1.03}, 2, time);
  const Outcome linear = run_cylinder({"pipe", 100, 200, 40, 40, 1.03}, 1, time);
  for (const double t : {0.0, 0.01, 0.1, 1.0, 10.0, 200.0})
    EXPECT_RELATIVE(linear.history.at("theta100", t), fine.history.at("theta100", t), 1e-2);
}

}  // namespace
}  // namespace creepcontact
