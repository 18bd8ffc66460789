/// Orthotropic constants that follow a temperature that changes in time, each by a factor of its own: a held bar whose
/// axes are turned, and a shrink fit with radial and hoop axes that loosens, separates and closes again.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxes.hpp"
#include "case.hpp"
#include "rings.hpp"

namespace creepcontact::test {
namespace hot_anisotropy_tests {
namespace {

// The bar along z, its axis 3 turned from z towards x by this angle.
constexpr double turned = 0.6;
constexpr double expansion = 1.2e-5;

double modulus_1(double rise) {
  return 1.2e5 * (1 - 2e-4 * rise);
}
double modulus_3(double rise) {
  return 2.2e5 * (1 - 9e-4 * rise);
}
double shear_modulus_13(double rise) {
  return 6e4 * (1 - 6e-4 * rise);
}
double poisson_ratio_13(double rise) {
  return 0.2 + 1e-4 * rise;
}

/// Young's modulus of the bar. Lekhnitskiy, Theory of Elasticity of an Anisotropic Body (1981), section 9.
double turned_modulus(double rise) {
  const double c = std::cos(turned), s = std::sin(turned);
  return 1 / (std::pow(s, 4) / modulus_1(rise) + std::pow(c, 4) / modulus_3(rise) +
              (1 / shear_modulus_13(rise) - 2 * poisson_ratio_13(rise) / modulus_1(rise)) * s * s * c * c);
}

/// Its faces z0 and z1 stay in their planes; its sides are free and may shear.
std::string turned_bar(const std::string& temperature, const std::string& creep) {
  return fmt::format(R"(
    [mesh]
    file = "case.geo"
    order = 1
    [bodies.bar]
    region = "bar"
    material = "crystal"
    material_axes = {{ first = [{0}, 0, {1}], second = [0, 1, 0] }}
    [materials.crystal]
    thermal_expansion = {2}
    reference_temperature = 20
    [materials.crystal.orthotropic]
    young_moduli = ['1.2e5*(1 - 2e-4*(T - 20))', '1.6e5*(1 - 3e-4*(T - 20))', '2.2e5*(1 - 9e-4*(T - 20))']
    poisson_ratios = [0.3, 0.25, '0.2 + 1e-4*(T - 20)']
    shear_moduli = ['5e4*(1 - 5e-4*(T - 20))', 7e4, '6e4*(1 - 6e-4*(T - 20))']
  )",
                     std::cos(turned), -std::sin(turned), expansion) +
         creep + support("corner", "x") + support("bar_y0", "y") + support("bar_z0", "z") + support("bar_z1", "z") +
         "[temperature]\nvalue = \"" + temperature + "\"\nrefactor_change = 0.3\n" +
         probe("stress", "stress_zz", "body = \"bar\"") +
         probe("stress_x", "stress_xx", "body = \"bar\"\nreduce = \"max\"");
}

std::string turned_bar_geo() {
  return boxes_geo({{"bar", {0, 0, 0}, {1, 1, 4}, {1, 1, 4}}}) +
         "corner[] = Point In BoundingBox {-0.1, -0.1, -0.1, 0.1, 0.1, 0.1};\nPhysical Point(\"corner\") = corner[];\n";
}

TEST(TurnedHeldBar, IsPressedByTheConstantsOfTheMoment) {
  const Outcome outcome =
      run_case(turned_bar("20 + 3*t", "") + "[time]\nend = 100\noutput = [25, 50, 100]\n", turned_bar_geo());
  for (const double t : {25.0, 50.0, 100.0}) {
    const double exact = -turned_modulus(3 * t) * expansion * 3 * t;
    EXPECT_RELATIVE(outcome.history.at("stress", t), exact, 1e-8);
    EXPECT_NEAR(outcome.history.at("stress_x", t), 0, 1e-8 * std::abs(exact));
  }
  EXPECT_GT(outcome.summary.number("elastic_solves"), 4) << "the constants change by different factors";
}

/// sigma = E(T) (-alpha (T - 20) - eps_c), d(eps_c)/dt = A q^n dq/dsigma with Hill's q = R |sigma|, by the
/// Runge-Kutta method of order 4.
TEST(TurnedHeldBar, RelaxesByHillsCreepWhileItIsHeatedAndCooled) {
  const double A = 1e-17, n = 5, R1 = 0.9, R2 = 1.1, R3 = 1.2, R13 = 0.8;
  const double c = std::cos(turned), s = std::sin(turned);
  const double F = (1 / (R2 * R2) + 1 / (R3 * R3) - 1 / (R1 * R1)) / 2,
               G = (1 / (R3 * R3) + 1 / (R1 * R1) - 1 / (R2 * R2)) / 2,
               H = (1 / (R1 * R1) + 1 / (R2 * R2) - 1 / (R3 * R3)) / 2, M = 1.5 / (R13 * R13);
  const double s11 = s * s, s33 = c * c, s13 = s * c;
  const double ratio = std::sqrt(F * s33 * s33 + G * std::pow(s33 - s11, 2) + H * s11 * s11 + 2 * M * s13 * s13);
  const auto stress = [](double t, double creep) {
    const double rise = 150 * (1 - std::cos(0.1 * t));
    return turned_modulus(rise) * (-expansion * rise - creep);
  };
  const auto rate = [&](double t, double creep) {
    const double sigma = stress(t, creep);
    return A * std::pow(ratio * std::abs(sigma), n) * ratio * (sigma > 0 ? 1 : -1);
  };
  const double h = 1e-3;
  double creep = 0, largest = 0;
  std::vector<double> exact{0};
  for (int i = 0; i < 100000; ++i) {
    const double t = i * h;
    const double k1 = rate(t, creep), k2 = rate(t + h / 2, creep + h / 2 * k1),
                 k3 = rate(t + h / 2, creep + h / 2 * k2), k4 = rate(t + h, creep + h * k3);
    creep += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if ((i + 1) % 10000 == 0) exact.push_back(stress(t + h, creep));
    largest = std::max(largest, std::abs(exact.back()));
  }
  const std::string law = fmt::format(
      "[[materials.crystal.creep]]\nlaw = \"norton\"\nA = {}\nn = {}\n"
      "[materials.crystal.hill]\nnormal = [{}, {}, {}]\nshear = [1, 1, {}]\n",
      A, n, R1, R2, R3, R13);
  for (const char* solver : {"krylov", "tangent"}) {
    const Outcome outcome =
        run_case(turned_bar("20 + 150*(1 - cos(0.1*t))", law) +
                     "[time]\nend = 100\ntolerance = 1e-6\noutput = [10, 20, 30, 40, 50, 60, 70, 80, 90, 100]\n",
                 turned_bar_geo(), {fmt::format("time.linear_solver={}", solver)});
    for (int i = 1; i <= 10; ++i) EXPECT_NEAR(outcome.history.at("stress", i * 10), exact[i], 1e-5 * largest) << solver;
  }
  EXPECT_GT(*std::ranges::max_element(exact), 0.05 * largest) << "what crept in the heat pulls in the cold";
}

/// An isotropic shaft in an orthotropic hub with radial and hoop axes, at the temperature 20 + rise.
struct ForgedFit {
  static constexpr double a = 50, b = 100;
  const std::vector<RingMesh> rings{{"shaft", 20, a, 6, 11}, {"hub", a, b, 8, 9}};
  const std::string bodies = R"(
    [mesh]
    file = "case.geo"
    order = 2
    [bodies.shaft]
    region = "shaft"
    material = "shaft"
    [bodies.hub]
    region = "hub"
    material = "hub"
    material_axes = { first = ["x", "y", 0], second = ["-y", "x", 0] }
    [materials.shaft]
    young_modulus = '2.1e5*(1 - 3e-4*(T - 20))'
    poisson_ratio = 0.3
    thermal_expansion = 1.1e-5
    reference_temperature = 20
    [materials.hub]
    thermal_expansion = 1.8e-5
    reference_temperature = 20
    [materials.hub.orthotropic]
    young_moduli = ['1.2e5*(1 - 2e-4*(T - 20))', '2.1e5*(1 - 7e-4*(T - 20))', 1.5e5]
    poisson_ratios = [0.2, 0.3, 0.25]
    shear_moduli = ['5e4*(1 - 4e-4*(T - 20))', 6e4, 5e4]
  )";

  static double interference(double rise) { return 0.05 + (1.1e-5 - 1.8e-5) * rise * a; }
  /// Displacements at the interface per pressure: of the shaft by Lame, of the hub by Lekhnitskiy, Anisotropic Plates
  /// (1968), section 28.
  static double pressure(double rise) {
    const double E = 2.1e5 * (1 - 3e-4 * rise), ratio = 20 / a;
    const double shaft = a / E * ((1 + ratio * ratio) / (1 - ratio * ratio) - 0.3);
    const double radial = 1.2e5 * (1 - 2e-4 * rise), hoop = 2.1e5 * (1 - 7e-4 * rise), k = std::sqrt(hoop / radial);
    const double power = std::pow(a / b, 2 * k);
    const double hub = a * (k / hoop * (1 + power) / (1 - power) + 0.2 / radial);
    return interference(rise) / (shaft + hub);
  }
};

TEST(HotForgedFit, LoosensSeparatesAndClosesAgain) {
  const ForgedFit fit;
  for (const double bound : {0.0, 0.5}) {
    const Outcome outcome = run_case(
        fit.bodies + ring_supports(fit.rings, false) + contact_table("shaft_outer", "hub_inner", "gap = -0.05") +
            fmt::format("[temperature]\nvalue = \"20 + 200*t*(2 - t)\"\nrefactor_change = {}\n", bound) +
            "[time]\nend = 2\noutput = [0.1, 0.2, 0.4, 1, 1.6, 1.8, 2]\n" +
            probe("pressure", "contact_pressure", "on = \"shaft_outer\"") + probe("gap", "gap", "on = \"shaft_outer\""),
        rings_geo(fit.rings, 4));
    const double cold = outcome.history.at("pressure", 0);
    EXPECT_RELATIVE(cold, ForgedFit::pressure(0), 5e-3);
    for (const double t : {0.1, 0.2, 0.4, 1.0, 1.6, 1.8, 2.0}) {
      const double rise = 200 * t * (2 - t), interference = ForgedFit::interference(rise);
      if (interference > 0) {
        // The mesh's part of the error is that of the cold fit.
        EXPECT_RELATIVE(outcome.history.at("pressure", t) / cold, ForgedFit::pressure(rise) / ForgedFit::pressure(0),
                        2e-4);
      } else {
        EXPECT_NEAR(outcome.history.at("pressure", t), 0, 1e-9 * cold);
        EXPECT_RELATIVE(outcome.history.at("gap", t), -interference, 1e-3);
      }
    }
    EXPECT_LT(ForgedFit::interference(200), 0) << "it must separate";
  }
}

}  // namespace
}  // namespace hot_anisotropy_tests
}  // namespace creepcontact::test
