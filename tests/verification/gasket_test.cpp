/// Gaskets between two bars of section 1 between walls, and in a ring: joint diagram, unloading, creep. The bars in
/// series have 150 MPa/mm; the gasket loads along a table and unloads with 200 + 400 m MPa/mm from the largest closure
/// m.

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/interrupted.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace gasket_tests {
namespace {

using namespace test;

constexpr double modulus = 1500, half = 5, S = modulus / (2 * half);
constexpr double preload = 50, largest = 0.5857142857142857, slope = 200 + 400 * largest;

const std::string geo =
    boxes_geo({{"low", {0, 0, 0}, {1, 1, half}, {2, 2, 2}}, {"high", {0, 0, half}, {1, 1, half}, {3, 3, 2}}});

const std::string graphite = R"toml(
  [gaskets.graphite]
  thickness = 4.5
  loading = { closure = [0, 0.1, 0.25, 0.5, 0.8, 1.2], pressure = [0, 4, 15, 40, 75, 140] }
  unloading = { from = [15, 40, 75], modulus = [1350, 1800, 2340] }
)toml";

/// @param gasket  keys of the gasket @param contact  of the contact @param rest  [time] and what follows
std::string joint(const std::string& gasket, const std::string& contact, const std::string& rest) {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("low", modulus, 0) + body("high", modulus, 0) +
                     graphite + gasket + "\n" + contact_table("low_z1", "high_z0", "gasket = \"graphite\"\n" + contact);
  for (const std::string name : {"low", "high"}) toml += support(name + "_x0", "x") + support(name + "_y0", "y");
  toml += support("low_z0", "z") + support("high_z1", "z");
  for (const char* quantity : {"contact_pressure", "closure", "closure_max", "creep_closure", "gap"})
    toml += probe(quantity, quantity, "on = \"low_z1\"");
  return toml + probe("wall", "reaction_z", "on = \"low_z0\"") + rest;
}

/// A pressure inside the joint that pushes its faces apart.
std::string opening(const std::string& pressure) {
  std::string toml;
  for (const char* face : {"low_z1", "high_z0"})
    toml += fmt::format("[[loads]]\non = \"{}\"\npressure = {}\n", face, pressure);
  return toml;
}

const std::string by_force = "preload = { force = 50 }";

TEST(Gasket, IsTightenedByForceAndCarriesItsPartOfAnOpeningForce) {
  const Table history = run_case(joint("", by_force, "[time]\nend = 4\noutput = [1, 2, 3]\n") +
                                     opening("{ t = [0, 1, 2, 3, 4], values = [0, 15, 0, 30, 0] }"),
                                 geo)
                            .history;
  EXPECT_NEAR(history.at("contact_pressure", 0), preload, 1e-7);
  EXPECT_NEAR(history.at("closure", 0), largest, 1e-9);
  const double share = slope / (S + slope);
  EXPECT_NEAR(history.at("contact_pressure", 1), preload - 15 * share, 1e-7);
  EXPECT_NEAR(history.at("wall", 1), preload + 15 * (1 - share), 1e-7) << "what the bolts carry";
  EXPECT_NEAR(history.at("contact_pressure", 2), preload, 1e-7);
  EXPECT_NEAR(history.at("contact_pressure", 3), preload - 30 * share, 1e-7);
  EXPECT_NEAR(history.at("contact_pressure", 4), preload, 1e-7) << "the path is closed";
  EXPECT_NEAR(history.at("closure_max", 4), largest, 1e-9);
}

/// A bar is pushed in and drawn out: loading, unloading below the residual closure, and loading again.
TEST(Gasket, UnloadsToItsResidualClosureAndLoadsAgainFromThere) {
  const Table history = run_case(joint("", "gap = { t = [0, 1, 2, 3, 4], values = [0, -1, 0, -1, -1.2] }",
                                       "[time]\nend = 4\noutput = [0.5, 1, 1.2, 2, 3]\n"),
                                 geo)
                            .history;
  // closure + pressure/S = overlap, on the loading curve
  const auto loaded = [](double overlap) {  // between 0.5 and 0.8 mm
    const double pressure = (overlap - 0.5 + 40 / (35 / 0.3)) / (1 / S + 1 / (35 / 0.3));
    return std::pair(pressure, overlap - pressure / S);
  };
  const auto [pressure, closure] = loaded(1);
  EXPECT_NEAR(history.at("contact_pressure", 1), pressure, 1e-9);
  EXPECT_NEAR(history.at("closure", 1), closure, 1e-11);
  const double residual = closure - pressure / (200 + 400 * closure);
  EXPECT_NEAR(history.at("contact_pressure", 1.2), (0.8 - residual) / (1 / S + 1 / (200 + 400 * closure)), 1e-9);
  EXPECT_EQ(history.at("contact_pressure", 2), 0);
  EXPECT_NEAR(history.at("gap", 2), residual, 1e-9) << "the gasket has become thinner";
  EXPECT_NEAR(history.at("closure", 2), 0, 1e-9);
  EXPECT_NEAR(history.at("contact_pressure", 3), pressure, 1e-9);
  EXPECT_NEAR(history.at("contact_pressure", 4), loaded(1.2).first, 1e-9);
}

double relaxed(double t) {
  constexpr double a = 2e-13, n = 5;
  const double k = 1 / (1 / S + 1 / slope);
  return std::pow(std::pow(preload, 1 - n) + (n - 1) * a * k * t, 1 / (1 - n));
}

const std::string norton = "creep = [{ law = \"norton\", A = 4.444444444444444e-14, n = 5 }]";

class GasketCreep : public testing::TestWithParam<std::string> {};

TEST_P(GasketCreep, RelaxesThePreload) {
  const Outcome outcome =
      run_case(joint(norton, by_force,
                     fmt::format("[time]\nend = 1e5\ntolerance = 1e-4\noutput = [100, 1e4]\n{}\n", GetParam())),
               geo);
  for (const double t : {100.0, 1e4, 1e5}) {
    EXPECT_NEAR(outcome.history.at("contact_pressure", t), relaxed(t), 1e-4 * preload) << t;
    const double creep = outcome.history.at("creep_closure", t);
    EXPECT_NEAR(creep, (preload - outcome.history.at("contact_pressure", t)) * (1 / S + 1 / slope), 1e-9);
    EXPECT_NEAR(outcome.history.at("closure", t),
                largest + creep - (preload - outcome.history.at("contact_pressure", t)) / slope, 1e-9);
    EXPECT_NEAR(outcome.history.at("closure_max", t), largest, 1e-9) << "without creep the closure falls";
  }
  EXPECT_NEAR(relaxed(1e5), 18.21741, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Integrators, GasketCreep,
                         testing::Values("", "integrator = \"log_adams\"", "integrator = \"cvode_bdf\"",
                                         "integrator = \"cvode_bdf\"\nlinear_solver = \"tangent\"",
                                         "integrator = \"arkode_dirk\"", "integrator = \"arkode_erk\"",
                                         "integrator = \"cvode_adams\"",
                                         "integrator = \"beta_euler\"\nstep = \"adaptive\"",
                                         "integrator = \"explicit_euler\"\nstep = \"adaptive\""));

TEST(Gasket, CreepsAsItsRelaxationTestSays) {
  // P_QR 0.85 from 50 MPa in 4 h, in a rig of 1000 kN/mm on 4762 mm2; in this joint 0.8731 are left.
  const Table history =
      run_case(joint("relaxation = { factor = 0.85, pressure = 50, stiffness = 1e6, area = 4762, time = 4 }", by_force,
                     "[time]\nend = 4\ntolerance = 1e-5\n"),
               geo)
          .history;
  EXPECT_NEAR(history.at("contact_pressure", 4) / preload, 0.8731, 5e-5);
}

/// The largest closure lies within a step where nothing but temperature makes it, and unloading depends on it.
TEST(Gasket, RemembersAMaximumBetweenItsSteps) {
  const auto run = [](double tolerance) {
    return run_case(joint(norton, "gap = \"-0.5 - 0.4*sin(_pi*t/1000)\"",
                          fmt::format("[time]\nend = 1000\ntolerance = {}\n", tolerance)),
                    geo)
        .history.at("contact_pressure", 1000);
  };
  const double exact = run(1e-6);
  EXPECT_NEAR(run(1e-3), exact, 1e-3 * 50);
  EXPECT_NEAR(run(1e-4), exact, 1e-4 * 50);
}

TEST(Gasket, GrowsWithTheTemperature) {
  const Table history = run_case(joint("thermal_expansion = 5e-5\nreference_temperature = 20", "gap = -0.3",
                                       "[temperature]\nvalue = \"20 + 100*t\"\n[time]\nend = 2\noutput = [1]\n"),
                                 geo)
                            .history;
  // 4.5 x 5e-5 x 200 = 0.045 mm more of overlap at the end
  const auto pressure = [](double overlap) { return (overlap - 0.1 + 4 / (11 / 0.15)) / (1 / S + 0.15 / 11); };
  EXPECT_NEAR(history.at("contact_pressure", 0), pressure(0.3), 1e-9);
  EXPECT_NEAR(history.at("contact_pressure", 2), pressure(0.345), 1e-9);
}

TEST(Gasket, ResumesExactly) {
  const std::string toml =
      joint(norton, by_force, "[time]\nend = 1000\nintegrator = \"log_adams\"\n") + opening("\"10*sin(_pi*t/1000)\"");
  const CaseDirectory directory(geo);
  expect_same_when_resumed(directory.config(toml, {}), directory.path(), {300, 700});
}

TEST(Gasket, SaysWhatIsNotPossible) {
  const auto message = [](const std::string& gasket, const std::string& contact) {
    return message_of<Error>([&] { run_case(joint(gasket, contact, "[time]\nend = 1\n"), geo); });
  };
  EXPECT_TRUE(says(message("", "type = \"tied\""), {"gasket", "tied"}));
  EXPECT_TRUE(says(message("creep = []\nrelaxation = { factor = 0.8, pressure = 50, area = 1, time = 4 }", by_force),
                   {"stiffness"}));
}

}  // namespace
}  // namespace gasket_tests
}  // namespace creepcontact
