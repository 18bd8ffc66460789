/// Plane and axisymmetric sections against closed forms and radial references.

#include <fmt/format.h>

#include <numbers>

#include "creepcontact/base/error.hpp"
#include "creepcontact/model/model.hpp"
#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/reference/hot_cylinder.hpp"
#include "verification/reference/ring_fit.hpp"
#include "verification/reference/thick_cylinder.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace section_cases {
namespace {

using test::Outcome;
using test::Region;

constexpr double quarter = std::numbers::pi / 2;

std::string pressure_on(const std::string& curve, double value) {
  return fmt::format("[[loads]]\non = \"{}\"\npressure = {}\n", curve, value);
}

Region quarter_ring(const std::string& name, double inner, double outer, int radial, int around) {
  return {name, {inner, outer, radial, 1.03}, {0, quarter, around}, true};
}

std::string symmetry(const std::string& name) {
  return test::support(name + "_y0", "y") + test::support(name + "_y1", "x");
}

constexpr reference::ThickCylinder cylinder{100, 200, 200};
constexpr double A = 3.125e-14, n = 5;

/// Both ends of an axisymmetric wall are held.
struct Wall {
  std::string analysis;
  Region region;
  std::string supports;
};

Wall thick_wall(const std::string& analysis) {
  if (analysis == "axisymmetric")
    return {analysis,
            {"pipe", {100, 200, 14, 1.03}, {0, 10, 2}},
            test::support("pipe_y0", "y") + test::support("pipe_y1", "y")};
  return {analysis, quarter_ring("pipe", 100, 200, 14, 18), symmetry("pipe")};
}

std::string wall_probes(const Wall& wall) {
  std::string toml;
  for (const double r : {100, 150, 200}) {
    const std::string at = fmt::format("at = [{}, {}, 0]", r, wall.analysis == "axisymmetric" ? 5 : 0);
    toml += test::probe(fmt::format("theta{}", r), "stress_theta", at);
    toml += test::probe(fmt::format("r{}", r), "stress_r", at);
    toml += test::probe(fmt::format("axial{}", r), wall.analysis == "axisymmetric" ? "stress_yy" : "stress_zz", at);
  }
  return toml;
}

void expect_steady(const test::Table& history) {
  for (const double r : {100.0, 150.0, 200.0}) {
    const double tolerance = 200 * (r == 150 ? 1e-3 : 3e-3);
    EXPECT_NEAR(history.at(fmt::format("theta{}", r), 200), cylinder.steady_sigma_theta(r, n), tolerance) << r;
    EXPECT_NEAR(history.at(fmt::format("r{}", r), 200), cylinder.steady_sigma_r(r, n), tolerance) << r;
    EXPECT_NEAR(history.at(fmt::format("axial{}", r), 200), cylinder.steady_sigma_z(r, n), tolerance) << r;
  }
}

TEST(SectionOfCylinder, ReachesTheSteadyState) {
  for (const std::string analysis : {"axisymmetric", "plane_strain"}) {
    const Wall wall = thick_wall(analysis);
    const Outcome outcome =
        test::run_case(test::section_of(analysis) + test::body("pipe", 200e3, 0.3, A, n) + wall.supports +
                           pressure_on("pipe_x0", 200) + "[time]\nend = 200\ntolerance = 1e-5\n" + wall_probes(wall),
                       test::regions_geo({wall.region}));
    EXPECT_RELATIVE(outcome.history.at("theta100", 0), cylinder.elastic_sigma_theta(100), 3e-3);
    EXPECT_NEAR(outcome.history.at("axial150", 0), cylinder.elastic_sigma_z(0.3), 0.02);
    expect_steady(outcome.history);
  }
}

// The force on the closed ends is that of the pressure: in the steady state the axial strain then stands still, and
// the stresses are those of plane strain.
TEST(SectionOfCylinder, WithClosedEndsInGeneralizedPlaneStrain) {
  const Wall wall = thick_wall("generalized_plane_strain");
  const double force = 200 * std::numbers::pi * 100 * 100 / 4;
  const Outcome outcome = test::run_case(
      test::section_of(wall.analysis) + "thickness = 3\n" + test::body("pipe", 200e3, 0.3, A, n) + wall.supports +
          pressure_on("pipe_x0", 200) + fmt::format("[generalized_plane_strain]\nforce = {}\n", force) +
          "[time]\nend = 200\ntolerance = 1e-5\noutput = [190, 200]\n" + wall_probes(wall) +
          test::probe("strain", "axial_strain", "body = \"pipe\"") +
          test::probe("force", "axial_force", "body = \"pipe\""),
      test::regions_geo({wall.region}));
  const double sigma_z = 200.0 / 3;  // uniform in elastic closed ends
  EXPECT_NEAR(outcome.history.at("axial100", 0), sigma_z, 0.2);
  EXPECT_RELATIVE(outcome.history.at("strain", 0), (1 - 2 * 0.3) * sigma_z / 200e3, 1e-4);
  for (const double t : {0.0, 190.0, 200.0}) EXPECT_RELATIVE(outcome.history.at("force", t), force, 1e-6);
  expect_steady(outcome.history);
  EXPECT_NEAR(outcome.history.at("strain", 200), outcome.history.at("strain", 190), 2e-7);
}

TEST(SectionOfCylinder, OpenEndsAndPrescribedStrain) {
  const Wall wall = thick_wall("generalized_plane_strain");
  const auto run = [&](const std::string& axial) {
    return test::run_case(test::section_of(wall.analysis) + test::body("pipe", 200e3, 0.3) + wall.supports +
                              pressure_on("pipe_x0", 200) + axial + "[time]\nend = 1\n" + wall_probes(wall) +
                              test::probe("strain", "axial_strain", "body = \"pipe\"") +
                              test::probe("force", "axial_force", "body = \"pipe\""),
                          test::regions_geo({wall.region}))
        .history;
  };
  const test::Table open = run("");
  EXPECT_NEAR(open.at("axial150", 0), 0, 0.05);
  EXPECT_NEAR(open.at("force", 0), 0, 1e-6);
  EXPECT_RELATIVE(open.at("strain", 0), -2 * 0.3 * (200.0 / 3) / 200e3, 1e-4);
  const test::Table pulled = run("[generalized_plane_strain]\nstrain = \"2e-4*(1 + t)\"\n");
  EXPECT_RELATIVE(pulled.at("strain", 1), 4e-4, 1e-12);
  EXPECT_NEAR(pulled.at("axial150", 0), 200e3 * 2e-4 + cylinder.elastic_sigma_z(0.3), 0.05);
  EXPECT_NEAR(pulled.at("theta150", 1), cylinder.elastic_sigma_theta(150), 0.2);
}

// The node of the axial strain is none of the body's: neither in means over it nor in field files.
TEST(GeneralizedPlaneStrain, AxialNodeIsInNoField) {
  const test::CaseDirectory directory(test::regions_geo({{"plate", {0, 2, 3}, {0, 1, 2}}}));
  config::Config config = directory.config(
      test::section_of("generalized_plane_strain") + test::body("plate", 100, 0.3) + test::support("plate_x0", "x") +
          test::support("plate_y0", "y") + "[generalized_plane_strain]\nforce = 10\n[time]\nend = 1\n" +
          test::probe("mean", "displacement_x", "body = \"plate\"") +
          test::probe("out", "displacement_z", "body = \"plate\"\nreduce = \"max\"") +
          test::probe("strain", "axial_strain", "body = \"plate\""),
      {});
  const auto results = directory.path() / "results";
  const run::Summary result = run::run(config, {.output = results.string()});
  ASSERT_EQ(result.exit_status, 0) << result.message;
  EXPECT_TRUE(std::filesystem::exists(results / "fields.pvd"));
  const test::Table history(results / "history.csv");
  EXPECT_RELATIVE(history.at("strain", 0), 10.0 / 2 / 100, 1e-9);
  EXPECT_RELATIVE(history.at("mean", 0), -0.3 * 0.05, 1e-9);  // half of the width of 2
  EXPECT_EQ(history.at("out", 0), 0);
}

// Steady state of a hollow sphere under internal pressure; the section reaches the axis.
TEST(SectionOfSphere, ReachesTheSteadyState) {
  const Region region{"wall", {100, 200, 16, 1.04}, {0, quarter, 32}, true};
  std::string toml = test::section_of("axisymmetric") + test::body("wall", 200e3, 0.3, A, n) +
                     test::support("wall_y0", "y") + pressure_on("wall_x0", 200) +
                     "[time]\nend = 1000\ntolerance = 1e-5\n";
  const std::array<double, 3> radii{100, 150, 200};
  for (const double r : radii) {
    toml += test::probe(fmt::format("pole{}", r), "stress_theta", fmt::format("at = [0, {}, 0]", r));
    toml += test::probe(fmt::format("equator{}", r), "stress_theta", fmt::format("at = [{}, 0, 0]", r));
    toml += test::probe(fmt::format("radial{}", r), "stress_yy", fmt::format("at = [0, {}, 0]", r));
  }
  const Outcome outcome = test::run_case(toml, test::regions_geo({region}));
  for (const double r : radii) {
    const double tolerance = 200 * (r == 150 ? 2e-3 : 6e-3);
    const auto lame = [&](double sign) { return 200 / 7.0 * (1 + sign * 8e6 / (r * r * r)); };
    const double k = std::pow(2.0, 3 / n) - 1, shape = std::pow(200 / r, 3 / n);
    const double radial = -200 * (shape - 1) / k, hoop = 200 / k * (1 - (1 - 1.5 / n) * shape);
    for (const char* place : {"pole", "equator"}) {
      EXPECT_NEAR(outcome.history.at(fmt::format("{}{}", place, r), 0), lame(0.5), tolerance) << place << r;
      EXPECT_NEAR(outcome.history.at(fmt::format("{}{}", place, r), 1000), hoop, tolerance) << place << r;
    }
    EXPECT_NEAR(outcome.history.at(fmt::format("radial{}", r), 0), lame(-1), tolerance) << r;
    EXPECT_NEAR(outcome.history.at(fmt::format("radial{}", r), 1000), radial, tolerance) << r;
  }
}

// A disc in plane stress that turns about its axis. With n = 1 the steady state is the elastic one for nu = 1/2.
TEST(SpinningDisc, ElasticAndWithLinearCreep) {
  const double a = 40, b = 200, load = 8e-9 * 300 * 300;
  const auto exact = [&](double nu, double r, bool hoop) {
    const double c = a * a * b * b / (r * r);
    return load / 8 * ((3 + nu) * (a * a + b * b + (hoop ? c : -c)) - (hoop ? 1 + 3 * nu : 3 + nu) * r * r);
  };
  const Outcome outcome = test::run_case(
      test::section_of("plane_stress") + "thickness = 7\n" + test::body("disc", 2e5, 0.3, 1e-6, 1) + symmetry("disc") +
          "[[loads]]\nbody = \"disc\"\nrotation = { axis = [0, 0, 1], angular_velocity = 300, density = 8e-9 }\n" +
          "[time]\nend = 100\ntolerance = 1e-5\n" + test::probe("bore", "stress_theta", "at = [40, 0, 0]") +
          test::probe("theta", "stress_theta", "at = [120, 0, 0]") + test::probe("r", "stress_r", "at = [120, 0, 0]") +
          test::probe("zz", "stress_zz", "body = \"disc\"\nreduce = \"max\""),
      test::regions_geo({{"disc", {a, b, 16, 1.05}, {0, quarter, 18}, true}}));
  for (const auto& [t, nu] : {std::pair(0.0, 0.3), std::pair(100.0, 0.5)}) {
    EXPECT_RELATIVE(outcome.history.at("bore", t), exact(nu, a, true), 3e-3);
    EXPECT_RELATIVE(outcome.history.at("theta", t), exact(nu, 120, true), 1e-3);
    EXPECT_RELATIVE(outcome.history.at("r", t), exact(nu, 120, false), 1e-3);
    EXPECT_NEAR(outcome.history.at("zz", t), 0, 1e-9);
  }
}

// A long solid shaft that turns, in plane strain: finite stresses on the axis, where no support holds it.
TEST(SpinningShaft, IsRegularOnItsAxis) {
  const double b = 100, nu = 0.3, load = 8e-9 * 600 * 600;
  const Outcome outcome = test::run_case(
      test::section_of("axisymmetric") + test::body("shaft", 2e5, nu) + test::support("shaft_y0", "y") +
          test::support("shaft_y1", "y") +
          "[[loads]]\nbody = \"shaft\"\nrotation = { angular_velocity = 600, density = 8e-9 }\n[time]\nend = 1\n" +
          test::probe("axis_r", "stress_r", "at = [0, 5, 0]") +
          test::probe("axis_t", "stress_theta", "at = [0, 5, 0]") +
          test::probe("rim", "stress_theta", "at = [100, 5, 0]"),
      test::regions_geo({{"shaft", {0, b, 20}, {0, 10, 2}}}));
  const double centre = (3 - 2 * nu) / (8 * (1 - nu)) * load * b * b;
  const double rim = (3 - 2 * nu) / (8 * (1 - nu)) * load * b * b * (1 - (1 + 2 * nu) / (3 - 2 * nu));
  EXPECT_RELATIVE(outcome.history.at("axis_r", 0), centre, 1e-3);
  EXPECT_RELATIVE(outcome.history.at("axis_t", 0), centre, 1e-3);
  EXPECT_RELATIVE(outcome.history.at("rim", 0), rim, 2e-3);
}

// A pipe wall with a logarithmic temperature, creeping at a rate that follows it.
TEST(HotCylinder, AxisymmetricFollowsTheRadialReference) {
  const double a = 100, b = 150, E = 1.6e5, nu = 0.3, expansion = 1.4e-5;
  const auto temperature = [&](double r) { return 500 + 50 * std::log(b / r) / std::log(b / a); };
  const auto factor = [&](double r) { return 1e-17 * std::exp(0.03 * (temperature(r) - 500)); };
  const reference::HotCylinderHistory exact(
      {a, b, 40, E, nu, 5, factor, [&](double r) { return expansion * (temperature(r) - 20); }});
  const std::vector<double> times{100, 1e3, 1e4};
  const auto stress = exact.stress(times);
  std::string toml = test::section_of("axisymmetric") + R"toml(
    [bodies.pipe]
    region = "pipe"
    material = "steel"
    [materials.steel]
    young_modulus = 1.6e5
    poisson_ratio = 0.3
    thermal_expansion = 1.4e-5
    reference_temperature = 20
    [[materials.steel.creep]]
    law = "norton"
    A = "1e-17*exp(0.03*(T - 500))"
    n = 5.0
    [temperature]
    value = "500 + 50*log(150/x)/log(1.5)"
  )toml" + test::support("pipe_y0", "y") +
                     test::support("pipe_y1", "y") + pressure_on("pipe_x0", 40) +
                     "[time]\nend = 1e4\ntolerance = 1e-5\noutput = [100, 1e3, 1e4]\n";
  const std::vector<double>& radii = exact.radii();
  const std::vector<std::size_t> places{1, radii.size() / 2, radii.size() - 2};
  for (const std::size_t i : places)
    for (const char* component : {"r", "theta"})
      toml += test::probe(fmt::format("{}{}", component, i), fmt::format("stress_{}", component),
                          fmt::format("at = [{:.12g}, 3, 0]", radii[i]));
  const Outcome outcome = test::run_case(toml, test::regions_geo({{"pipe", {a, b, 16}, {0, 6, 2}}}));
  double largest = 0;
  for (const Eigen::Vector3d& at : stress[0]) largest = std::max(largest, at.cwiseAbs().maxCoeff());
  for (std::size_t k = 0; k < times.size(); ++k)
    for (const std::size_t i : places) {
      EXPECT_NEAR(outcome.history.at(fmt::format("r{}", i), times[k]), stress[k][i][0], 1e-3 * largest);
      EXPECT_NEAR(outcome.history.at(fmt::format("theta{}", i), times[k]), stress[k][i][1], 1e-3 * largest);
    }
}

// Norton's law under constant biaxial stress in plane stress, and constant strain.
TEST(PlaneStress, UniformCreepHasItsThirdStrain) {
  const Outcome outcome = test::run_case(
      test::section_of("plane_stress") + test::body("plate", 2e5, 0.3, A, n) + test::support("plate_x0", "x") +
          test::support("plate_y0", "y") + pressure_on("plate_x1", -200) + pressure_on("plate_y1", 200) +
          "[time]\nend = 1000\ntolerance = 1e-6\n" + test::probe("xx", "creep_strain_xx", "body = \"plate\"") +
          test::probe("zz", "creep_strain_zz", "body = \"plate\"") + test::probe("e", "strain_zz", "body = \"plate\"") +
          test::probe("u", "displacement_x", "on = \"plate_x1\""),
      test::regions_geo({{"plate", {0, 10, 3}, {0, 10, 2}}}));
  EXPECT_RELATIVE(outcome.history.at("xx", 1000), 135, 1e-6);  // NAFEMS R0027, test 3A
  EXPECT_NEAR(outcome.history.at("zz", 1000), 0, 1e-6);
  EXPECT_RELATIVE(outcome.history.at("u", 0), 10 * 200 * 1.3 / 2e5, 1e-9);
  EXPECT_NEAR(outcome.history.at("e", 1000), 0, 1e-6);
}

struct FitCase {
  std::string analysis;
  reference::Plane plane;
  int order;
};

class SectionFit : public testing::TestWithParam<FitCase> {};

TEST_P(SectionFit, RelaxesLikeTheRadialReferenceOverSixDecades) {
  const auto& [analysis, plane, order] = GetParam();
  const bool is_ring = analysis == "axisymmetric";
  const int fine = order == 1 ? 5 : 1;
  std::vector<Region> regions;
  std::string supports;
  if (is_ring) {
    regions = {{"shaft", {40, 60, 8 * fine}, {0, 10, 3}},
               {"disc", {60, 120, 14 * fine, order == 1 ? 1.03 : 1.1}, {0, 10, 2}}};
    for (const char* end : {"shaft_y0", "shaft_y1", "disc_y0", "disc_y1"}) supports += test::support(end, "y");
  } else {
    regions = {quarter_ring("shaft", 40, 60, 7, 24), {"disc", {60, 120, 12, 1.12}, {0, quarter, 20}, true}};
    supports = symmetry("shaft") + symmetry("disc");
  }
  const std::vector<double> times{1, 100, 1e4, 1e5, 1e6};
  const Outcome outcome =
      test::run_case(test::section_of(analysis, order) + test::body("shaft", 1.75e5, 0.3, 2e-18, 5) +
                         test::body("disc", 1.6e5, 0.3, 1e-17, 5) + supports +
                         test::contact_table("shaft_x1", "disc_x0", "gap = -0.09") +
                         "[time]\nend = 1e6\ntolerance = 1e-5\noutput = [1, 100, 1e4, 1e5, 1e6]\n" +
                         test::probe("mean", "contact_pressure", "on = \"shaft_x1\"") +
                         test::probe("area", "contact_area", "on = \"shaft_x1\""),
                     test::regions_geo(regions));
  const reference::RingFit exact({40, 60, 1.75e5, 0.3, 2e-18, 5}, {60, 120, 1.6e5, 0.3, 1e-17, 5}, 0.09, plane);
  EXPECT_RELATIVE(outcome.history.at("area", 0), is_ring ? 2 * std::numbers::pi * 600 : quarter * 60, 1e-4);
  const std::vector<double> pressure = exact.pressure(times);
  const double tolerance = is_ring ? (order == 1 ? 1e-3 : 1e-4) : 1e-3;
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_RELATIVE(outcome.history.at("mean", times[i]), pressure[i], tolerance) << times[i];
}

INSTANTIATE_TEST_SUITE_P(Cases, SectionFit,
                         testing::Values(FitCase{"axisymmetric", reference::Plane::strain, 2},
                                         FitCase{"axisymmetric", reference::Plane::strain, 1},
                                         FitCase{"plane_strain", reference::Plane::strain, 2},
                                         FitCase{"plane_stress", reference::Plane::stress, 2}),
                         [](const auto& of) { return fmt::format("{}_order{}", of.param.analysis, of.param.order); });

/// Compound cylinder, its rings bonded, under internal pressure: Lame in each ring, the radial displacement continuous.
struct BondedRings {
  static constexpr double a = 40, c = 60, b = 120, pressure = 100, stiff = 2e5, soft = 5e4, nu = 0.3;
  static double compliance(double modulus, double inner, double outer, double r, bool outside) {
    const double k = (1 + nu) / modulus / (outer * outer - inner * inner);
    const double own = outside ? outer * outer : inner * inner, other = outside ? inner * inner : outer * outer;
    return k * (own * (1 - 2 * nu) * r + own * other / r);
  }
  static double interface_pressure() {
    const double opened = compliance(stiff, a, c, c, false) * pressure;
    return opened / (compliance(stiff, a, c, c, true) + compliance(soft, c, b, c, false));
  }
};

TEST(BondedSections, CurvedInterfaceThatDoesNotMatch) {
  using B = BondedRings;
  const double exact = B::interface_pressure();
  std::vector<double> errors;
  for (const int fine : {2, 4}) {
    const Outcome outcome = test::run_case(
        test::section_of("plane_strain") + test::body("inner", B::stiff, B::nu) + test::body("outer", B::soft, B::nu) +
            symmetry("inner") + symmetry("outer") + test::contact_table("inner_x1", "outer_x0", "type = \"tied\"") +
            pressure_on("inner_x0", B::pressure) + "[time]\nend = 1\n" +
            test::probe("min", "contact_pressure", "on = \"inner_x1\"\nreduce = \"min\"") +
            test::probe("max", "contact_pressure", "on = \"inner_x1\"\nreduce = \"max\"") +
            test::probe("force", "contact_force_x", "on = \"outer_x0\"") +
            test::probe("r", "stress_r", "at = [43.30127, 25, 0]"),
        test::regions_geo({quarter_ring("inner", B::a, B::c, 4 * fine, 5 * fine),
                           quarter_ring("outer", B::c, B::b, 6 * fine, 7 * fine)}));
    EXPECT_RELATIVE(outcome.history.at("force", 0), exact * B::c, 4e-4 / (fine * fine * fine));
    errors.push_back(std::max(std::abs(outcome.history.at("min", 0) / exact - 1),
                              std::abs(outcome.history.at("max", 0) / exact - 1)));
  }
  EXPECT_LT(errors[1], 2e-5);
  EXPECT_LT(errors[1], errors[0] / 3.5);  // of second order
}

// One layer of hex20 between held faces has the equations of quad8 in plane strain: the same results to rounding.
TEST(SectionAgainstSlice, CreepingBlocksInPlaneStrain) {
  const std::string common = test::body("block", 1, 0.3, 0.05, 3) + test::body("foot", 2, 0.3, 0.02, 3) +
                             test::support("foot_y0", "y") + test::support("foot_x0", "x") +
                             test::support("block_y1", "y", "-0.05") +
                             test::contact_table("block_y0", "foot_y1", "gap = \"0.02*x^2\"") +
                             "[time]\nend = 10\ntolerance = 1e-6\noutput = [1, 10]\n" +
                             test::probe("force", "contact_force_y", "on = \"block_y0\"") +
                             test::probe("q", "von_mises", "body = \"foot\"\nreduce = \"max\"") +
                             test::probe("area", "contact_area", "on = \"block_y0\"") + test::support("block_x0", "x");
  const std::vector<Region> regions{{"block", {0, 1, 5}, {0, 1, 4}}, {"foot", {0, 1.5, 6}, {-1, 0, 4}}};
  std::string solid_geo = "SetFactory(\"OpenCASCADE\");\n";
  std::string ends;
  for (const Region& region : regions) {
    solid_geo += fmt::format(
        "s = news; Rectangle(s) = {{{0}, {1}, 0, {2}, {3}}}; b[] = Abs(Boundary{{ Surface{{s}}; }});\n"
        "Transfinite Curve{{b[0], b[2]}} = {4} + 1; Transfinite Curve{{b[1], b[3]}} = {5} + 1;\n"
        "Transfinite Surface{{s}}; Recombine Surface{{s}};\n"
        "o[] = Extrude {{0, 0, 0.5}} {{ Surface{{s}}; Layers{{1}}; Recombine; }};\n"
        "Physical Volume(\"{6}\") = {{o[1]}}; Physical Surface(\"{6}_ends\") = {{s, o[0]}};\n"
        "Physical Surface(\"{6}_y0\") = {{o[2]}}; Physical Surface(\"{6}_x1\") = {{o[3]}};\n"
        "Physical Surface(\"{6}_y1\") = {{o[4]}}; Physical Surface(\"{6}_x0\") = {{o[5]}};\n",
        region.first.from, region.second.from, region.first.to - region.first.from,
        region.second.to - region.second.from, region.first.divisions, region.second.divisions, region.name);
    ends += test::support(region.name + "_ends", "z");
  }
  const Outcome section =
      test::run_case(test::section_of("plane_strain") + "thickness = 0.5\n" + common, test::regions_geo(regions));
  const Outcome solid = test::run_case("[mesh]\nfile = \"case.geo\"\norder = 2\n" + common + ends, solid_geo);
  for (const double t : {0.0, 1.0, 10.0})
    for (const char* probe : {"force", "q", "area"})
      EXPECT_RELATIVE(section.history.at(probe, t), solid.history.at(probe, t), 1e-4) << probe << t;
  EXPECT_RELATIVE(section.history.at("force", 0), solid.history.at("force", 0), 1e-8);
}

// Plates of different thickness: the contact has the smaller one, and the pressure is that on it.
TEST(PlaneStress, ContactOfPlatesOfDifferentThickness) {
  for (const char* slave : {"auto", "upper_y0", "lower_y1"}) {
    std::string toml = test::section_of("plane_stress") + test::body("lower", 1e5, 0.3) + test::body("upper", 1e5, 0.3);
    toml.insert(toml.find("region = \"upper\""), "thickness = 5\n");
    toml.insert(toml.find("region = \"lower\""), "thickness = 2\n");
    const Outcome outcome = test::run_case(
        toml + test::support("lower_y0", "y") + test::support("lower_x0", "x") + test::support("upper_x0", "x") +
            test::contact_table("lower_y1", "upper_y0", fmt::format("slave = \"{}\"", slave)) +
            pressure_on("upper_y1", 40) + "[time]\nend = 1\n" +
            test::probe("p", "contact_pressure", "on = \"upper_y0\"") +
            test::probe("area", "contact_area", "on = \"upper_y0\"") +
            test::probe("held", "reaction_y", "on = \"lower_y0\"") +
            test::probe("stress", "stress_yy", "body = \"lower\""),
        test::regions_geo({{"lower", {0, 10, 4}, {-3, 0, 2}}, {"upper", {0, 10, 5}, {0, 3, 2}}}));
    EXPECT_RELATIVE(outcome.history.at("held", 0), 40 * 10 * 5, 1e-9);
    EXPECT_RELATIVE(outcome.history.at("area", 0), 20, 1e-9) << slave;
    EXPECT_RELATIVE(outcome.history.at("p", 0), 100, 1e-9) << slave;
    EXPECT_RELATIVE(outcome.history.at("stress", 0), -100, 1e-9);
  }
}

// A load on the axis has no area to act on.
TEST(SectionForces, LoadsOnTheAxisAreRefused) {
  const test::CaseDirectory directory(test::regions_geo({{"shaft", {0, 3, 3}, {0, 1, 2}}}));
  const std::string common = test::section_of("axisymmetric") + test::body("shaft", 1e5, 0.3) +
                             test::support("shaft_y0", "y") + "[time]\nend = 1\n";
  for (const char* load : {"on = \"shaft_x0\"\npressure = 3\n", "at = [0, 1, 0]\nforce = [1, 0, 0]\n"}) {
    const std::string message =
        test::message_of<ModelError>([&] { model::build_model(directory.config(common + "[[loads]]\n" + load, {})); });
    EXPECT_TRUE(test::says(message, {"loads[0]", "axis"}));
  }
  EXPECT_NO_THROW(model::build_model(directory.config(common + "[[loads]]\nat = [0, 1, 0]\nforce = [0, -1, 0]\n", {})));
}

// A stepped ring pressed together by its own weight and a ring force: reactions of the full circumference.
TEST(SectionForces, WeightAndRingForceOfTheFullCircumference) {
  const Outcome outcome = test::run_case(
      test::section_of("axisymmetric") + test::body("lower", 1e5, 0.3) + test::body("upper", 1e5, 0.3) +
          test::support("lower_y0", "y") + test::contact_table("lower_y1", "upper_y0") +
          "[[loads]]\nbody = \"upper\"\nbody_force = [0, -0.02, 0]\n[[loads]]\nat = [3, 2, 0]\nforce = [0, -5, 0]\n" +
          "[[loads]]\non = \"upper_x1\"\ntraction = [0, -0.3, 0]\n[time]\nend = 1\n" +
          test::probe("held", "reaction_y", "on = \"lower_y0\"") +
          test::probe("through", "contact_force_y", "on = \"upper_y0\""),
      test::regions_geo({{"lower", {1, 3, 5}, {0, 1, 3}}, {"upper", {1, 3, 4}, {1, 2, 3}}}));
  const double weight = 0.02 * std::numbers::pi * 8, side = 0.3 * 2 * std::numbers::pi * 3;
  EXPECT_RELATIVE(outcome.history.at("held", 0), weight + side + 5, 1e-9);
  EXPECT_RELATIVE(outcome.history.at("through", 0), weight + side + 5, 1e-9);
}

}  // namespace
}  // namespace section_cases
}  // namespace creepcontact
