// Orthotropic elasticity and Hill's creep with axes that depend on the place, against closed forms.

#include <cmath>

#include "verification/cube.hpp"

namespace creepcontact {
namespace anisotropy_tests {
namespace {

using namespace test;

constexpr double angle = 0.4;  // of axis 1 against x

/// The constants of the cube's material made orthotropic, its axes turned about z.
std::string turned_toml(const std::string& material, const std::string& loading, const std::string& time) {
  std::string toml = cube_toml(material, loading, time);
  const auto replace = [&](const std::string& what, const std::string& by) {
    const std::size_t at = toml.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    toml.replace(at, what.size(), by);
  };
  replace("material = \"steel\"",
          fmt::format("material = \"steel\"\nmaterial_axes = {{ first = [{}, {}, 0], second = [0, 1, 0] }}",
                      std::cos(angle), std::sin(angle)));
  replace("\"y0\"", "\"corner\"");  // the face y = 0 tilts with the shear
  if (material.find("orthotropic") != std::string::npos) {
    replace("young_modulus = 200e3", "");
    replace("poisson_ratio = 0.3", "");
  }
  return toml;
}

const std::string orthotropic =
    "\n[materials.steel.orthotropic]\nyoung_moduli = [200e3, 150e3, 120e3]\npoisson_ratios = [0.25, 0.3, 0.35]\n"
    "shear_moduli = [40e3, 50e3, 60e3]\n";

const std::string turned_geo = std::string(cube_geo) + "Physical Point(\"corner\") = {1};\n";

TEST(Orthotropic, TurnedBarStretchesAsLekhnitskiySays) {
  const Outcome outcome = run_case(turned_toml(orthotropic, pulled("100"), "end = 1\noutput = [1]\n"), turned_geo);
  const double c = std::cos(angle), s = std::sin(angle);
  const double compliance =
      std::pow(c, 4) / 200e3 + std::pow(s, 4) / 150e3 + (1 / 40e3 - 2 * 0.25 / 200e3) * s * s * c * c;
  EXPECT_RELATIVE(outcome.history.at("exx", 1), 100 * compliance, 1e-10);
}

/// f dq/dstress with the stress s along an axis in the plane of axes 1 and 2.
TEST(Hill, TurnedBarCreepsAlongTheGradientOfTheEquivalentStress) {
  const double R1 = 1.0, R2 = 0.8, R3 = 1.2, R12 = 0.7, A = 1e-14, n = 5, pull = 100, duration = 50;
  const Outcome outcome =
      run_case(turned_toml(creep_law_table("norton", "A = 1e-14\nn = 5") +
                               "\n[materials.steel.hill]\nnormal = [1.0, 0.8, 1.2]\nshear = [0.7, 1, 1]\n",
                           pulled("100"), "end = 50\noutput = [50]\ntolerance = 1e-6\n"),
               turned_geo);
  const double F = (1 / (R2 * R2) + 1 / (R3 * R3) - 1 / (R1 * R1)) / 2,
               G = (1 / (R3 * R3) + 1 / (R1 * R1) - 1 / (R2 * R2)) / 2,
               H = (1 / (R1 * R1) + 1 / (R2 * R2) - 1 / (R3 * R3)) / 2, N = 1.5 / (R12 * R12);
  const double c = std::cos(angle), s = std::sin(angle);
  const double s11 = pull * c * c, s22 = pull * s * s, s12 = -pull * s * c;
  const double q = std::sqrt(F * s22 * s22 + G * s11 * s11 + H * std::pow(s11 - s22, 2) + 2 * N * s12 * s12);
  const double factor = A * std::pow(q, n) / q * duration;
  const double e11 = factor * (G * s11 + H * (s11 - s22)), e22 = factor * (F * s22 - H * (s11 - s22)),
               e12 = factor * N * s12;
  EXPECT_RELATIVE(outcome.history.at("cxx", 50), c * c * e11 + s * s * e22 - 2 * s * c * e12, 1e-6);
  EXPECT_RELATIVE(outcome.history.at("cyy", 50), s * s * e11 + c * c * e22 + 2 * s * c * e12, 1e-6);
}

/// All ratios doubled are a law of 2^-(n+1) times the rate: relaxation needs the right Jacobian too.
TEST(Hill, EqualRatiosScaleTheLaw) {
  const std::string held = support("x1", "x", "0.1"), time = "end = 100\noutput = [1, 10, 100]\ntolerance = 1e-6\n";
  const Outcome by_ratios =
      run_case(turned_toml(creep_law_table("norton", "A = 6.4e-12\nn = 5") +
                               "\n[materials.steel.hill]\nnormal = [2, 2, 2]\nshear = [2, 2, 2]\n",
                           held, time),
               turned_geo);
  const Outcome by_law = run_cube(creep_law_table("norton", "A = 1e-13\nn = 5"), held, time);
  for (const double t : {1.0, 10.0, 100.0})
    EXPECT_RELATIVE(by_ratios.history.at("sxx", t), by_law.history.at("sxx", t), 1e-5);
  EXPECT_LT(by_law.history.at("sxx", 100), 100);  // of 200 at first
}

/// Ratios of 1 change nothing, also where damage depends on the principal stress or the volume creeps.
TEST(Hill, RatiosOfOneChangeNothing) {
  const std::string pull = pulled("100") + "[[loads]]\non = \"y1\"\npressure = -60\n",
                    time = "end = 10\noutput = [10]\ntolerance = 1e-6\n",
                    ones = "\n[materials.steel.hill]\nnormal = [1, 1, 1]\nshear = [1, 1, 1]\n";
  for (const std::string& law :
       {creep_law_table("kachanov_rabotnov", "A = 1e-13\nn = 5\nB = 1e-10\nr = 4\nphi = 3\nalpha = 0.7"),
        creep_law_table("hereditary", "compliances = [1e-5]\ntimes = [5]\nvolumetric_compliances = [2e-6]")}) {
    const Outcome with = run_cube(law + ones, pull, time), without = run_cube(law, pull, time);
    for (const char* probe : {"cxx", "cyy", "exx"})
      EXPECT_RELATIVE(with.history.at(probe, 10), without.history.at(probe, 10), 1e-6);
    if (law.find("kachanov") != std::string::npos) {
      EXPECT_RELATIVE(with.history.at("damage", 10), without.history.at("damage", 10), 1e-6);
    }
  }
}

const char* const ring_geo = R"(
  Point(1) = {50, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {0, 100, 0}; Point(4) = {0, 50, 0}; Point(5) = {0, 0, 0};
  Line(1) = {1, 2}; Circle(2) = {2, 5, 3}; Line(3) = {3, 4}; Circle(4) = {4, 5, 1};
  Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
  Transfinite Curve{1, 3} = 13; Transfinite Curve{2, 4} = 13; Transfinite Surface{1}; Recombine Surface{1};
  Physical Surface("ring") = {1};
  Physical Curve("y0") = {1}; Physical Curve("x0") = {3}; Physical Curve("bore") = {4};
)";

/// Lekhnitskiy, Anisotropic Plates (1968), section 28, with k = sqrt(E_theta/E_r).
TEST(Orthotropic, RingUnderPressureWithRadialAndHoopAxes) {
  for (const std::string analysis : {"plane_stress", "solid"}) {
    const bool solid = analysis == "solid";
    std::string geo = ring_geo;
    if (solid)
      geo = geo.substr(0, geo.find("  Physical Surface")) +
            "out[] = Extrude {0, 0, 5} { Surface{1}; Layers{1}; Recombine; };\n"
            "Physical Volume(\"ring\") = {out[1]}; Physical Surface(\"z0\") = {1};\n"
            "Physical Surface(\"y0\") = {out[2]}; Physical Surface(\"x0\") = {out[4]};\n"
            "Physical Surface(\"bore\") = {out[5]};\n";
    const Outcome outcome = run_case("analysis = \"" + analysis + R"("
    [mesh]
    file = "case.geo"
    order = 2
    [bodies.ring]
    region = "ring"
    material = "forging"
    material_axes = { first = ["x", "y", 0], second = ["-y", "x", 0] }
    [materials.forging.orthotropic]
    young_moduli = [100e3, 225e3, 150e3]
    poisson_ratios = [0.2, 0.3, 0.25]
    shear_moduli = [50e3, 50e3, 50e3]
    [[loads]]
    on = "bore"
    pressure = 80
    )" + support("x0", "x") + support("y0", "y") +
                                         (solid ? support("z0", "z") : "") + R"(
    [time]
    end = 1
    output = [1]
    [[probes]]
    name = "hoop"
    quantity = "stress_yy"
    at = [75, 0, 0]
    body = "ring"
    [[probes]]
    name = "radial"
    quantity = "stress_xx"
    at = [75, 0, 0]
    body = "ring"
  )",
                                     geo);
    const double k = 1.5, c = 0.5, x = 0.75, p = 80, factor = p * std::pow(c, k + 1) / (1 - std::pow(c, 2 * k));
    EXPECT_RELATIVE(outcome.history.at("radial", 1), factor * (std::pow(x, k - 1) - std::pow(x, -k - 1)), 5e-3);
    EXPECT_RELATIVE(outcome.history.at("hoop", 1), factor * k * (std::pow(x, k - 1) + std::pow(x, -k - 1)), 5e-3);
  }
}

}  // namespace
}  // namespace anisotropy_tests
}  // namespace creepcontact
