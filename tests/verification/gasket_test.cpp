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
#include "verification/plane_regions.hpp"
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

/// Pressed askew, with half of the gasket near its toe, and creeping.
TEST(Gasket, IsSolvedByEveryMethod) {
  const auto run = [](const std::vector<std::string>& overrides) {
    return run_case(
               joint("creep = [{ law = \"norton\", A = 4e-14, n = 5 }]", "gap = \"-0.2 - 0.3*x\"",
                     "[time]\nend = 100\n" + probe("most", "contact_pressure", "on = \"low_z1\"\nreduce = \"max\"")),
               geo, overrides)
        .history;
  };
  const Table direct = run({"contact_solver.method=active_set"});
  for (const char* other : {"contact_solver.acceleration=cg", "contact_solver.acceleration=none",
                            "contact_solver.acceleration=anderson", "contact_solver.dense_limit_mb=0"}) {
    const Table history = run({other});
    for (const double t : {0.0, 100.0})
      for (const char* name : {"most", "closure_max", "wall"})
        EXPECT_RELATIVE(history.at(name, t), direct.at(name, t), 1e-6) << other << ", " << name;
  }
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
  const bool is_euler = GetParam().find("euler") != std::string::npos;  // errors of whose steps add up
  for (const double t : {100.0, 1e4, 1e5}) {
    EXPECT_NEAR(outcome.history.at("contact_pressure", t), relaxed(t), (is_euler ? 1e-3 : 1e-4) * preload) << t;
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

TEST(Gasket, CreepsWithTheOrderOfTheMethod) {
  const auto error = [](const std::string& method, int steps) {
    const Outcome run = run_case(
        joint(norton, by_force, fmt::format("[time]\nend = 400\nstep = {}\n{}\n", 400.0 / steps, method)), geo);
    return std::abs(run.history.at("contact_pressure", 400) - relaxed(400));
  };
  const std::string implicit = "integrator = \"beta_euler\"\nbeta = ";
  for (const auto& [method, order] :
       {std::pair<std::string, int>{"integrator = \"explicit_euler\"", 1}, {implicit + "1", 1}, {implicit + "0.5", 2}})
    EXPECT_NEAR(std::log2(error(method, 20) / error(method, 40)), order, 0.1) << method;
}

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

TEST(Gasket, TellsTheErrorOfAMaximumBetweenItsSteps) {
  const auto run = [](const std::string& gap) {
    return run_case(joint(norton, "gap = " + gap, "[time]\nend = 1000\ntolerance = 1e-2\n"), geo)
        .summary.number("gasket_error");
  };
  const double turned = run("\"-0.5 - 0.4*sin(_pi*t/1000)\"");
  EXPECT_GT(turned, 1e-6);
  EXPECT_LT(turned, 1e-2);
  EXPECT_EQ(run("\"-0.5 - 0.0004*t\""), 0);
}

TEST(Gasket, WarnsOutsideTheRangesOfItsData) {
  const auto warnings = [](const std::string& gasket) {
    std::string all;
    for (const std::string& one :
         run_case(joint(gasket, by_force, "[temperature]\nvalue = \"20 + 100*t\"\n[time]\nend = 2\n"), geo)
             .summary.texts("warnings"))
      all += one + "\n";
    return all;
  };
  const std::string law = "creep = [{ law = \"norton\", A = 1e-20, n = 5, ", at_20 = "reference_temperature = 20\n";
  EXPECT_EQ(warnings(at_20 + law + "stress_range = [0, 60], temperature_range = [0, 300] }]"), "");
  const std::string outside = warnings(at_20 + law + "stress_range = [0, 40], temperature_range = [0, 100] }]");
  EXPECT_TRUE(says(outside, {"gasket 'graphite': creep[0]", "pressure", "50", "stress_range"})) << outside;
  EXPECT_TRUE(says(outside, {"gasket 'graphite': creep[0]", "temperature", "temperature_range"})) << outside;
  EXPECT_TRUE(says(warnings(at_20 + "thermal_expansion = { T = [0, 100], values = [1e-5, 2e-5] }"),
                   {"gasket 'graphite': thermal_expansion", "outside its table"}));
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

/// A steel beam on a layer that cannot pull, under a point load: contact up to pi/(2 beta) from it, and the closure
/// P beta/(2 k) coth(pi/2) under it, with beta^4 = k/(4 E I).
TEST(Gasket, CarriesABeamThatLiftsOff) {
  constexpr double k = 0.01, height = 4, E = 2e5, load = 10;
  const double beta = std::pow(k / (4 * E * std::pow(height, 3) / 12), 0.25);
  const std::string toml = section_of("plane_stress") + body("beam", E, 0) + body("block", 1e7, 0) +
                           "[gaskets.layer]\nthickness = 1\nloading = { closure = [0, 1], pressure = [0, 0.01] }\n" +
                           contact_table("beam_y0", "block_y1", "gasket = \"layer\"\nslave = \"beam_y0\"") +
                           support("block_y0", "x") + support("block_y0", "y") + support("beam_x0", "x") +
                           fmt::format("[[loads]]\non = \"beam_x0\"\ntraction = [0, {}, 0]\n", -load / 2 / height) +
                           probe("closure", "closure", "on = \"beam_y0\"\nreduce = \"max\"") +
                           probe("area", "contact_area", "on = \"beam_y0\"") + "[time]\nend = 1\n";
  const Table history =
      run_case(toml, regions_geo({{"beam", {0, 400, 200}, {0, height, 2}}, {"block", {0, 400, 50}, {-10, 0, 1}}}))
          .history;
  EXPECT_RELATIVE(history.at("closure", 1), load * beta / (2 * k) / std::tanh(M_PI / 2), 3e-3);
  EXPECT_RELATIVE(history.at("area", 1), M_PI / (2 * beta), 5e-3);
}

/// Thin and stiff against the bodies, a gasket is the layer of solid that it replaces: E/t per length, no shear.
TEST(Gasket, IsAThinLayerInTheLimit) {
  constexpr double thickness = 0.05, layer = 100, E = 1000;
  const auto run = [&](bool meshed) {
    const double top = meshed ? thickness : 0;
    std::string toml = section_of("plane_strain") + body("low", E, 0.3) + body("high", E, 0.3);
    std::vector<Region> regions{{"low", {0, 2, 16}, {-1, 0, 8}}, {"high", {0, 1, 16}, {top, top + 1, 8}}};
    if (meshed) {
      toml +=
          body("layer", layer, 0) + contact_table("low_y1", "layer_y0", "") + contact_table("layer_y1", "high_y0", "");
      toml += support("layer_x0", "x");
      regions.push_back({"layer", {0, 1, 16}, {0, thickness, 1}});
    } else {
      toml += fmt::format("[gaskets.layer]\nthickness = {}\nloading = {{ closure = [0, 1], pressure = [0, {}] }}\n",
                          thickness, layer / thickness) +
              contact_table("low_y1", "high_y0", "gasket = \"layer\"\nslave = \"high_y0\"");
    }
    toml += support("low_y0", "y") + support("low_x0", "x") + support("high_x0", "x") +
            "[[loads]]\non = \"high_y1\"\npressure = \"1 + x\"\n" +
            probe("edge", "displacement_y", fmt::format("at = [1, {}, 0]\nbody = \"high\"", top + 1)) +
            probe("middle", "displacement_y", fmt::format("at = [0, {}, 0]\nbody = \"high\"", top + 1)) +
            "[time]\nend = 1\n";
    const Table history = run_case(toml, regions_geo(regions)).history;
    return std::pair(history.at("middle", 1), history.at("edge", 1));
  };
  const auto [middle, edge] = run(false);
  const auto [meshed_middle, meshed_edge] = run(true);
  EXPECT_RELATIVE(middle, meshed_middle, 0.01);
  EXPECT_RELATIVE(edge, meshed_edge, 0.01);
}

/// A ring of the section, pressed by its weight and held sideways by friction on the gasket alone.
TEST(Gasket, HoldsAFloatingRingByFriction) {
  const std::string toml =
      section_of("axisymmetric") + body("low", 1000, 0) + body("high", 1000, 0) +
      "[gaskets.soft]\nthickness = 1\nloading = { closure = [0, 0.1, 0.2], pressure = [0, 0.5, 2] }\n" +
      contact_table("low_y1", "high_y0", "gasket = \"soft\"\nfriction = 0.3") + support("low_y0", "y") +
      "[[loads]]\non = \"high_y1\"\npressure = \"0.4 + 0.4*t\"\n[[loads]]\non = \"high_x0\"\npressure = \"0.02*t\"\n" +
      probe("closure", "closure", "on = \"low_y1\"") + probe("pressure", "gasket_pressure", "on = \"low_y1\"") +
      probe("shear", "contact_shear", "on = \"low_y1\"\nreduce = \"max\"") + "[time]\nend = 2\noutput = [1]\n";
  const Table history =
      run_case(toml, regions_geo({{"low", {100, 104, 4}, {0, 2, 2}}, {"high", {100, 104, 6}, {2, 3, 2}}})).history;
  EXPECT_NEAR(history.at("pressure", 1), 0.8, 1e-9);
  EXPECT_NEAR(history.at("pressure", 2), 1.2, 1e-9);
  EXPECT_NEAR(history.at("closure", 1), 0.1 + 0.1 * 0.3 / 1.5, 2e-3);
  EXPECT_GT(history.at("shear", 2), 1e-3);
}

TEST(Gasket, SaysWhatIsNotPossible) {
  const auto message = [](const std::string& gasket, const std::string& contact) {
    return message_of<Error>([&] { run_case(joint(gasket, contact, "[time]\nend = 1\n"), geo); });
  };
  EXPECT_TRUE(says(message("", "type = \"tied\""), {"gasket", "tied"}));
  EXPECT_TRUE(says(message("creep = []\nrelaxation = { factor = 0.8, pressure = 50, area = 1, time = 4 }", by_force),
                   {"stiffness"}));
}

/// Between two rings that do not match, by an overlap: Lame's flexibilities and that of the layer are in series.
/// Quarters with planes of symmetry, and as sectors.
TEST(Gasket, IsBetweenRingsAndInSectors) {
  constexpr double a = 30, b = 50, c = 80, E = 1e5, nu = 0.3, k = 2e3, overlap = 0.05;
  const std::vector<RingMesh> rings{{"shaft", a, b, 5, 16}, {"hub", b, c, 6, 14}};
  const auto run = [&](const std::string& sides) {
    const std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("shaft", E, nu) + body("hub", E, nu) +
                             "[gaskets.layer]\nthickness = 1\nloading = { closure = [0, 1], pressure = [0, 2000] }\n" +
                             sides + contact_table("shaft_outer", "hub_inner", "gap = -0.05\ngasket = \"layer\"") +
                             probe("pressure", "contact_pressure", "on = \"shaft_outer\"") +
                             probe("least", "gasket_pressure", "on = \"shaft_outer\"\nreduce = \"min\"") +
                             "[time]\nend = 1\n";
    return run_case(toml, rings_geo(rings, 4)).history;
  };
  const double outer = b / E * ((c * c + b * b) / (c * c - b * b) + nu),
               inner = b / E * ((b * b + a * a) / (b * b - a * a) - nu);
  const Table symmetric = run(ring_supports(rings, false));
  EXPECT_RELATIVE(symmetric.at("pressure", 1), overlap / (outer + inner + 1 / k), 2e-3);
  EXPECT_RELATIVE(symmetric.at("least", 1), symmetric.at("pressure", 1), 5e-3);
  std::string held;
  for (const RingMesh& ring : rings) held += support(ring.name + "_low", "z");
  const Table sector = run(held + "[[cyclic]]\nbetween = [\"symmetry_y\", \"symmetry_x\"]\nangle = 90\n");
  EXPECT_RELATIVE(sector.at("pressure", 1), overlap / (outer + inner + 1 / k), 2e-3);
}

// Springs between the two bars, each of 300 N/mm, whose outer ends are moved.

std::string sprung(const std::string& spring, const std::string& moved, const std::string& time) {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("low", modulus, 0) + body("high", modulus, 0) +
                     "[[springs]]\nname = \"washer\"\ndirection = [0, 0, 2]\n" + spring + "\n";
  for (const std::string name : {"low", "high"}) toml += support(name + "_x0", "x") + support(name + "_y0", "y");
  toml += support("low_z0", "z") + support("high_z1", "z", moved);
  return toml + probe("force", "spring_force", "on = \"washer\"") +
         probe("closure", "spring_closure", "on = \"washer\"") + probe("wall", "reaction_z", "on = \"low_z0\"") +
         "[time]\n" + time;
}

const std::string faces = "between = [\"low_z1\", \"high_z0\"]\n";

TEST(Spring, PushesAndPullsBetweenTheMeansOfSurfaces) {
  const Table history =
      run_case(sprung(faces + "stiffness = 150", "{ t = [0, 1, 2], values = [0, -1, 1] }", "end = 2\noutput = [1]\n"),
               geo)
          .history;
  EXPECT_NEAR(history.at("force", 1), 75, 1e-9);
  EXPECT_NEAR(history.at("closure", 1), 0.5, 1e-11);
  EXPECT_NEAR(history.at("wall", 1), 75, 1e-9);
  EXPECT_NEAR(history.at("force", 2), -75, 1e-9);
}

TEST(Spring, FollowsACurveAndDoesNotPullBelowItsFirstForce) {
  const std::string curve = "curve = { closure = [0, 0.2, 0.5], force = [0, 60, 90] }";
  const Table history =
      run_case(sprung(faces + curve, "{ t = [0, 1, 2], values = [0, -0.9, 1] }", "end = 2\noutput = [1]\n"), geo)
          .history;
  // closure + force/150 = 0.9 on the second piece, of 100 N/mm
  EXPECT_NEAR(history.at("force", 1), (0.9 - 0.2 + 60 / 100.0) / (1 / 150.0 + 1 / 100.0), 1e-9);
  EXPECT_EQ(history.at("force", 2), 0);
  EXPECT_NEAR(history.at("closure", 2), -1, 1e-9);
}

TEST(Spring, HasAPreloadWhereNothingHasMoved) {
  for (const char* spring : {"stiffness = 150", "curve = { closure = [1, 2, 3], force = [0, 150, 300] }"}) {
    const Table history =
        run_case(sprung(faces + spring + std::string("\npreload = 40"), "0", "end = 1\n"), geo).history;
    EXPECT_NEAR(history.at("force", 1), 20, 1e-9) << spring;
  }
}

TEST(Spring, ConnectsPointsAndTheGround) {
  const Table points =
      run_case(sprung("at = [[0, 0, 5], [0, 0, 5]]\nstiffness = 1e-3", "-1", "end = 1\n"), geo).history;
  EXPECT_NEAR(points.at("force", 1), 1e-3, 1e-7);
  const Table ground =
      run_case(sprung("on = \"high_z0\"\nground = true\nstiffness = 300", "-1", "end = 1\n"), geo).history;
  EXPECT_NEAR(ground.at("force", 1), 150, 1e-9);
  EXPECT_NEAR(ground.at("wall", 1), 0, 1e-9);
}

TEST(Spring, RelaxesByItsCreep) {
  constexpr double a = 1e-9, n = 4, start = 75, k = 1 / (2 / 300.0 + 1 / 150.0);
  const Table history = run_case(sprung(faces + "stiffness = 150\ncreep = [{ law = \"norton\", A = 1e-9, n = 4 }]",
                                        "-1", "end = 1000\ntolerance = 1e-5\noutput = [10]\n"),
                                 geo)
                            .history;
  for (const double t : {10.0, 1000.0})
    EXPECT_RELATIVE(history.at("force", t), std::pow(std::pow(start, 1 - n) + (n - 1) * a * k * t, 1 / (1 - n)), 3e-5);
}

TEST(Spring, SaysWhatIsNotPossible) {
  const auto message = [](const std::string& spring) {
    return message_of<Error>([&] { run_case(sprung(spring, "0", "end = 1\n"), geo); });
  };
  EXPECT_TRUE(says(message("stiffness = 1"), {"no place", "between"}));
  EXPECT_TRUE(says(message(faces), {"stiffness", "curve"}));
  EXPECT_TRUE(says(message(faces + "curve = { closure = [0, 1, 2], force = [0, 5, 5] }"), {"washer", "point 2", "5"}));
  EXPECT_TRUE(says(message("between = [\"low_z1\", \"hihg_z0\"]\nstiffness = 1"), {"hihg_z0"}));
  EXPECT_TRUE(says(message("at = [[0, 0, 0], [0, 0, 0]]\nstiffness = 1"), {"same node"}));
}

}  // namespace
}  // namespace gasket_tests
}  // namespace creepcontact
