/// Tension, then torsion of a thin tube that yields: the stress turns, and the return is of second order in the steps.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/plastic_point.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_torsion_tests {
namespace {

using namespace test;

constexpr double modulus = 1000, poisson_ratio = 0.3, shear_modulus = modulus / (2 * (1 + poisson_ratio));
const double k = 1 / std::numbers::sqrt3;  // yield stress in shear; in tension it is 1

/// Stresses of the wall of a tube.
struct Wall {
  double axial, shear;
};

/// A piece of the wall: its axis is z, and x and y are the principal directions of the shear, between which the strains
/// differ by it. The equations leave the mean of their strains free: no stress across the wall or around the tube.
/// @param twist  shear strain at the end @param n_steps  from tension to there
Wall run_tube(const std::string& plasticity, double twist, int n_steps, double tolerance = 1e-7) {
  std::string breakpoints = "1";
  for (int i = 1; i < n_steps; ++i) breakpoints += fmt::format(", {:.15g}", 1 + static_cast<double>(i) / n_steps);
  const std::string toml =
      section_of("generalized_plane_strain", 1) + body("wall", modulus, poisson_ratio) + "plasticity = " + plasticity +
      "\n[generalized_plane_strain]\nstrain = { t = [0, 1, 2], values = [0, 0.0015, 0.0015] }\n" +
      fmt::format(R"toml(
        [[equations]]
        terms = [{{ node = 2, x = 1 }}, {{ node = 3, x = -1 }}]
        [[equations]]
        terms = [{{ node = 4, y = 1 }}, {{ node = 3, y = -1 }}]
        [[equations]]
        terms = [{{ node = 2, x = 1 }}, {{ node = 4, y = -1 }}]
        value = {{ t = [0, 1, 2], values = [0, 0, {:.15g}] }}
        [time]
        end = 2
        tolerance = {:g}
        breakpoints = [{}]
      )toml",
                  twist, tolerance, breakpoints) +
      support("wall_x0", "x") + support("wall_y0", "y") + probe("x", "stress_xx", "body = \"wall\"") +
      probe("y", "stress_yy", "body = \"wall\"") + probe("z", "stress_zz", "body = \"wall\"");
  const Table history = run_case(toml, regions_geo({{"wall", {0, 1, 1}, {0, 1, 1}}})).history;
  const double x = history.at("x", 2), y = history.at("y", 2);
  EXPECT_NEAR(x + y, 0, 1e-6);
  return {history.at("z", 2), (x - y) / 2};
}

/// Perfectly plastic: G gamma/k = m atanh(s) + (1 - m) s with tau = k s, sigma = sqrt(1 - s^2), m = 3 G/E. For m = 1,
/// nu = 0.5, this is tau = k tanh(G gamma/k): Prandtl and Reuss; R. D. Krieg, D. B. Krieg, J. Pressure Vessel Technol.
/// 99 (1977) 510.
Wall exact_tube(double twist) {
  const double m = 3 * shear_modulus / modulus;
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double s = 0.5 * (low + high);
    (m * std::atanh(s) + (1 - m) * s < shear_modulus * twist / k ? low : high) = s;
  }
  return {std::sqrt(1 - low * low), k * low};
}

double distance(const Wall& a, const Wall& b) {
  return std::hypot(a.axial - b.axial, std::numbers::sqrt3 * (a.shear - b.shear));
}

/// Far from straight, with no breakpoint on the way: the error stays with the tolerance.
void expect_error_of_tolerance(const std::string& plasticity, double twist, const Wall& exact) {
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
    EXPECT_LT(distance(run_tube(plasticity, twist, 1, tolerance), exact), tolerance) << tolerance;
}

TEST(PlasticTube, TurnsFromTensionToTorsionWithinTheTolerance) {
  const double twist = 2 * k / shear_modulus;
  expect_error_of_tolerance("{ yield_stress = 1 }", twist, exact_tube(twist));
}

TEST(PlasticTube, StaysOnTheYieldSurfaceInAnyNumberOfSteps) {
  const Wall coarse = run_tube("{ yield_stress = 1 }", 3 * k / shear_modulus, 1);
  EXPECT_NEAR(std::hypot(coarse.axial, coarse.shear / k), 1, 1e-6);
}

/// Isotropic and kinematic hardening, against small explicit steps of the rate equations.
TEST(PlasticTube, HardensWithinTheTolerance) {
  const PlasticRates law{modulus, poisson_ratio, 1, 50, {{80, 0}, {200, 400}}};
  PlasticPath path(law);
  // x, y: lateral strains that differ by the shear; their sum is free.
  const double twist = 2.5 * k / shear_modulus;
  path.follow({.strain = {{{0, 0, 1, 0, 0, 0}, 0.0015}}, .free = {{1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}}}, 4000);
  path.follow({.strain = {{{0, 0, 1, 0, 0, 0}, 0}, {{1, -1, 0, 0, 0, 0}, twist}}, .free = {{1, 1, 0, 0, 0, 0}}}, 4000);
  const Wall exact{path.stress()[2], (path.stress()[0] - path.stress()[1]) / 2};
  expect_error_of_tolerance(
      "{ yield_stress = 1, hardening_modulus = 50, kinematic = [{ C = 80, gamma = 0 }, { C = 200, gamma = 400 }] }",
      twist, exact);
}

}  // namespace
}  // namespace plastic_torsion_tests
}  // namespace creepcontact
