/// Shrink fits: elastic in plane stress, relaxing in plane strain; creeping sheath on an elastic pellet.

#include <fmt/format.h>

#include "verification/case.hpp"
#include "verification/reference/ring_fit.hpp"
#include "verification/reference/sheath_on_pellet.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace {

using test::Outcome;

const std::string mesh_section = "[mesh]\nfile = \"case.geo\"\norder = 2\n";

std::string fit(const std::string& inside, const std::string& outside, double gap) {
  return fmt::format("[[contacts]]\nname = \"fit\"\nbetween = [\"{}_outer\", \"{}_inner\"]\ngap = {}\n", inside,
                     outside, gap);
}

TEST(ShrinkFit, ElasticPlaneStressPressure) {
  const std::vector<test::RingMesh> rings{{"shaft", 20, 50, 6, 11}, {"hub", 50, 100, 8, 9}};
  const double E = 2.1e5, interference = 0.05;
  const double ri = 20, R = 50, ro = 100;
  const double exact = E * interference / (2 * R * R * R) * (ro * ro - R * R) * (R * R - ri * ri) / (ro * ro - ri * ri);
  for (const char* method : {"schwarz", "active_set"}) {
    const Outcome outcome = test::run_case(
        mesh_section + test::body("shaft", E, 0.3) + test::body("hub", E, 0.3) + test::ring_supports(rings, false) +
            fit("shaft", "hub", -interference) + "[time]\nend = 1\n[contact_solver]\nmethod = \"" + method + "\"\n" +
            test::probe("mean", "contact_pressure", "on = \"shaft_outer\"") +
            test::probe("max", "contact_pressure", "on = \"shaft_outer\"\nreduce = \"max\"") +
            test::probe("min", "contact_pressure", "on = \"hub_inner\"\nreduce = \"min\"") +
            test::probe("force", "contact_force_x", "on = \"hub_inner\""),
        test::rings_geo(rings, 4));
    EXPECT_RELATIVE(outcome.history.at("mean", 0), exact, 5e-3);
    EXPECT_RELATIVE(outcome.history.at("max", 0), exact, 1e-2);
    EXPECT_RELATIVE(outcome.history.at("min", 0), exact, 1e-2);
    EXPECT_RELATIVE(outcome.history.at("force", 0), exact * R * 4, 5e-3);
  }
}

TEST(ShrinkFit, RelaxesLikeTheRadialReferenceOverFourDecades) {
  const std::vector<test::RingMesh> rings{{"shaft", 40, 60, 5, 10}, {"disc", 60, 120, 8, 9, 1.15}};
  const Outcome outcome = test::run_case(
      mesh_section + test::body("shaft", 1.75e5, 0.3, 2e-18, 5) + test::body("disc", 1.6e5, 0.3, 1e-17, 5) +
          test::ring_supports(rings, true) + fit("shaft", "disc", -0.09) +
          "[time]\nend = 1e6\ntolerance = 1e-4\noutput = [100, 1e3, 1e4, 1e5, 1e6]\n" +
          test::probe("mean", "contact_pressure", "on = \"shaft_outer\""),
      test::rings_geo(rings, 10));
  const reference::RingFit exact({40, 60, 1.75e5, 0.3, 2e-18, 5}, {60, 120, 1.6e5, 0.3, 1e-17, 5}, 0.09,
                                 reference::Plane::strain);
  EXPECT_RELATIVE(outcome.history.at("mean", 0), exact.elastic_pressure(), 5e-3);
  const std::vector<double> times{100, 1e3, 1e4, 1e5, 1e6};
  const std::vector<double> pressure = exact.pressure(times);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_RELATIVE(outcome.history.at("mean", times[i]), pressure[i], 5e-3);
  EXPECT_LE(outcome.summary.number("elastic_solves"), 400);
}

// SSNA105 of the code_aster validation manual (V6.01.105).
TEST(SheathOnPellet, FollowsTheClosedForm) {
  const std::vector<test::RingMesh> rings{{"pellet", 0.82, 0.98, 4, 12}, {"sheath", 1, 2, 12, 12, 1.06}};
  const reference::SheathOnPellet exact;
  // The bore pressure is a + b exp(-t) + c t: three values give it.
  const double p0 = exact.bore_pressure(0), p1 = exact.bore_pressure(0.5), p2 = exact.bore_pressure(1);
  const double e1 = std::exp(-0.5), e2 = std::exp(-1.0);
  const double b = (p2 - 2 * p1 + p0) / (e2 - 2 * e1 + 1);
  const double c = p2 - p0 - b * (e2 - 1);
  const double a = p0 - b;
  const Outcome outcome = test::run_case(
      mesh_section + test::body("pellet", 1, 0.3) + test::body("sheath", 1, 0.3, 1, 1) +
          test::ring_supports(rings, true) + fit("pellet", "sheath", 0.02) +
          fmt::format("[[loads]]\non = \"pellet_inner\"\npressure = \"{:.17g} + ({:.17g})*exp(-t) + ({:.17g})*t\"\n", a,
                      b, c) +
          "[time]\nend = 0.9\ntolerance = 1e-5\noutput = [0.3, 0.9]\n" +
          test::probe("pressure", "contact_pressure", "on = \"pellet_outer\"") +
          test::probe("force", "contact_force_x", "on = \"sheath_inner\"") +
          test::probe("u", "displacement_x", "at = [2, 0, 0.05]\nbody = \"sheath\"") +
          test::probe("theta", "stress_theta", "at = [2, 0, 0.05]\nbody = \"sheath\"") +
          test::probe("z", "stress_zz", "at = [2, 0, 0.05]\nbody = \"sheath\"") +
          test::probe("r", "stress_r", "at = [2, 0, 0.05]\nbody = \"sheath\""),
      test::rings_geo(rings, 0.1));
  const auto& row = outcome.history;
  EXPECT_RELATIVE(row.at("u", 0.9), 2.1450e-3, 1e-3);
  EXPECT_RELATIVE(row.at("theta", 0.9), 6.6667e-4, 1e-3);
  EXPECT_RELATIVE(row.at("z", 0.9), 2.7912e-4, 1e-3);
  EXPECT_NEAR(row.at("r", 0.9), 0, 1e-3 * 6.6667e-4);
  for (const double t : {0.0, 0.3, 0.9}) EXPECT_RELATIVE(row.at("force", t), 1e-3 * 0.1, 1e-3);
}

}  // namespace
}  // namespace creepcontact
