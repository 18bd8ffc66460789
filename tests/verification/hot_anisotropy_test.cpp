/// Orthotropic constants that follow a temperature that changes in time, each by a factor of its own: a held bar whose
/// axes are turned, and a shrink fit with radial and hoop axes that loosens, separates and closes again. Thermal
/// expansion that differs along the axes: a turned block and rings.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
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

/// Free to expand, its axes turned: strains are alpha (T - 20) along the axes, without stress.
TEST(TurnedBlock, ExpandsAlongItsAxesWithoutStress) {
  const Matrix3 axes = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.4).normalized().toRotationMatrix();
  const auto expansion = [](double T) { return Vector3(1e-5, 1.6e-5 + 4e-9 * (T - 20), -2e-6); };
  for (const bool orthotropic : {true, false})
    for (const bool hexahedra : {true, false})
      for (const int order : {1, 2}) {
        if (!hexahedra && order == 1) continue;  // linear tetrahedra are refused
        const std::string elasticity = orthotropic
                                           ? "orthotropic = { young_moduli = [2e5, 1.5e5, 1.2e5], poisson_ratios = "
                                             "[0.25, 0.3, 0.35], shear_moduli = [4e4, 5e4, 6e4] }"
                                           : "young_modulus = 2e5\npoisson_ratio = 0.3";
        const std::string toml =
            fmt::format(R"(
          [mesh]
          file = "case.geo"
          order = {}
          [bodies.block]
          region = "block"
          material = "crystal"
          material_axes = {{ first = [{}, {}, {}], second = [{}, {}, {}] }}
          [materials.crystal]
          thermal_expansion = [1e-5, '1.6e-5 + 4e-9*(T - 20)', -2e-6]
          reference_temperature = 20
          {}
          [temperature]
          value = "20 + 100*t"
          [time]
          end = 5
          output = [2, 5]
        )",
                        order, axes(0, 0), axes(1, 0), axes(2, 0), axes(0, 1), axes(1, 1), axes(2, 1), elasticity);
        const Outcome outcome =
            run_case(toml + "[[supports]]\non = \"o\"\ndisplacement = { x = 0, y = 0, z = 0 }\n" +
                         "[[supports]]\non = \"a\"\ndisplacement = { y = 0, z = 0 }\n" + support("b", "z") +
                         probe("x", "displacement_x", "at = [3, 2, 1]\nbody = \"block\"") +
                         probe("y", "displacement_y", "at = [3, 2, 1]\nbody = \"block\"") +
                         probe("z", "displacement_z", "at = [3, 2, 1]\nbody = \"block\"") +
                         probe("strain", "strain_xy", "body = \"block\"") +
                         probe("stress", "von_mises", "body = \"block\"\nreduce = \"max\"") +
                         probe("pressure", "hydrostatic", "body = \"block\"\nreduce = \"max\""),
                     boxes_geo({{"block", {0, 0, 0}, {3, 2, 1}, {2, 2, 2}, hexahedra}}) +
                         "o[] = Point In BoundingBox {-0.1, -0.1, -0.1, 0.1, 0.1, 0.1}; Physical Point(\"o\") = o[];\n"
                         "a[] = Point In BoundingBox {2.9, -0.1, -0.1, 3.1, 0.1, 0.1}; Physical Point(\"a\") = a[];\n"
                         "b[] = Point In BoundingBox {-0.1, 1.9, -0.1, 0.1, 2.1, 0.1}; Physical Point(\"b\") = b[];\n");
        for (const double t : {2.0, 5.0}) {
          const Matrix3 strain = axes * (expansion(20 + 100 * t) * 100 * t).asDiagonal() * axes.transpose();
          EXPECT_RELATIVE(outcome.history.at("x", t), 3 * strain(0, 0) + 4 * strain(0, 1) + 2 * strain(0, 2), 1e-9);
          EXPECT_RELATIVE(outcome.history.at("y", t), 2 * strain(1, 1) + 2 * strain(1, 2), 1e-9);
          EXPECT_RELATIVE(outcome.history.at("z", t), strain(2, 2), 1e-9);
          EXPECT_RELATIVE(outcome.history.at("strain", t), strain(0, 1), 1e-9);
          EXPECT_NEAR(outcome.history.at("stress", t), 0, 1e-8);
          EXPECT_NEAR(outcome.history.at("pressure", t), 0, 1e-8);
        }
      }
}

/// A free ring, heated evenly, whose coefficients along the radius and the circumference differ. It is in plane stress
/// whatever its length, for there is no contraction along its axis.
struct UnevenRing {
  static constexpr double a = 50, b = 100, E_r = 1e5, E_theta = 2.25e5, nu = 0.2, alpha_r = 1e-5, alpha_theta = 1.8e-5,
                          rise = 300;

  UnevenRing() {
    // sigma_r = Q11 u' + Q12 u/r - beta_r and so on; u = p r + c1 r^k + c2 r^-k
    const double k = std::sqrt(E_theta / E_r), scale = 1 - nu * nu * E_theta / E_r;
    Q << E_r, nu * E_theta, nu * E_theta, E_theta;
    Q /= scale;
    beta = Q * Eigen::Vector2d(alpha_r, alpha_theta) * rise;
    const double p = (beta[0] - beta[1]) / (Q(0, 0) - Q(1, 1));
    const auto radial = [&](double r, double power) { return (Q(0, 0) * power + Q(0, 1)) * std::pow(r, power - 1); };
    Eigen::Matrix2d at_edges;
    at_edges << radial(a, k), radial(a, -k), radial(b, k), radial(b, -k);
    const Eigen::Vector2d c = at_edges.inverse() * Eigen::Vector2d::Constant(beta[0] - (Q(0, 0) + Q(0, 1)) * p);
    terms = {{{p, 1}, {c[0], k}, {c[1], -k}}};
  }
  double displacement(double r) const {
    double sum = 0;
    for (const auto& [factor, power] : terms) sum += factor * std::pow(r, power);
    return sum;
  }
  double hoop_stress(double r) const {
    double slope = 0;
    for (const auto& [factor, power] : terms) slope += factor * power * std::pow(r, power - 1);
    return Q(0, 1) * slope + Q(1, 1) * displacement(r) / r - beta[1];
  }

  Eigen::Matrix2d Q;
  Eigen::Vector2d beta;
  std::array<std::pair<double, double>, 3> terms;
};

std::string uneven_ring_toml(const std::string& analysis, const std::string& of_body, const std::string& of_material) {
  return "analysis = \"" + analysis + R"("
    [mesh]
    file = "case.geo"
    order = 2
    [bodies.ring]
    region = "ring"
    material = "forging"
    )" + of_body +
         "\n[materials.forging]\nreference_temperature = 20\n" + of_material +
         "\n[temperature]\nvalue = 320\n[time]\nend = 1\noutput = [1]\n" +
         probe("moved", "displacement_x", "at = [50, 0, 0]\nbody = \"ring\"") +
         probe("bore", "stress_theta", "at = [50, 0, 0]\nbody = \"ring\"") +
         probe("middle", "stress_theta", "at = [75, 0, 0]\nbody = \"ring\"");
}

const std::string radial_hoop_axial =
    "thermal_expansion = [1e-5, 1.8e-5, 1.4e-5]\n"
    "orthotropic.young_moduli = [1e5, 2.25e5, 1.5e5]\northotropic.poisson_ratios = [0.2, 0, 0]\n"
    "orthotropic.shear_moduli = [5e4, 5e4, 5e4]\n";

void expect_uneven_ring(const Outcome& outcome) {
  const UnevenRing exact;
  EXPECT_RELATIVE(outcome.history.at("moved", 1), exact.displacement(50), 1e-4);
  EXPECT_RELATIVE(outcome.history.at("bore", 1), exact.hoop_stress(50), 5e-3);
  EXPECT_RELATIVE(outcome.history.at("middle", 1), exact.hoop_stress(75), 1e-2);
}

TEST(UnevenlyExpandingRing, AsASolidAndInPlaneStress) {
  const std::vector<RingMesh> rings{{"ring", 50, 100, 12, 12}};
  const std::string axes = "material_axes.cylindrical = { axis = [0, 0, 2] }";
  expect_uneven_ring(
      run_case(uneven_ring_toml("solid", axes, radial_hoop_axial) + ring_supports(rings, false), rings_geo(rings, 10)));
  expect_uneven_ring(
      run_case(uneven_ring_toml("plane_stress", axes, radial_hoop_axial) + support("x0", "x") + support("y0", "y"),
               R"(
    Point(1) = {50, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {0, 100, 0}; Point(4) = {0, 50, 0}; Point(5) = {0, 0, 0};
    Line(1) = {1, 2}; Circle(2) = {2, 5, 3}; Line(3) = {3, 4}; Circle(4) = {4, 5, 1};
    Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
    Transfinite Curve{1, 3} = 13; Transfinite Curve{2, 4} = 13; Transfinite Surface{1}; Recombine Surface{1};
    Physical Surface("ring") = {1}; Physical Curve("y0") = {1}; Physical Curve("x0") = {3};
  )"));
}

/// x is the radius, y the axis and z the circumference: axes 1, 2, 3 without `material_axes`.
TEST(UnevenlyExpandingRing, Axisymmetric) {
  const std::string geo = R"(
    Point(1) = {50, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {100, 10, 0}; Point(4) = {50, 10, 0};
    Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
    Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
    Transfinite Curve{1, 3} = 13; Transfinite Curve{2, 4} = 2; Transfinite Surface{1}; Recombine Surface{1};
    Physical Surface("ring") = {1}; Physical Curve("low") = {1};
  )";
  const std::string radial_axial_hoop =
      "thermal_expansion = [1e-5, 1.4e-5, 1.8e-5]\n"
      "orthotropic.young_moduli = [1e5, 1.5e5, 2.25e5]\northotropic.poisson_ratios = [0, 0, 0.2]\n"
      "orthotropic.shear_moduli = [5e4, 5e4, 5e4]\n";
  expect_uneven_ring(run_case(uneven_ring_toml("axisymmetric", "", radial_axial_hoop) + support("low", "y"), geo));
  const std::string cylindrical = "material_axes.cylindrical = { axis = [0, 1, 0] }";
  expect_uneven_ring(
      run_case(uneven_ring_toml("axisymmetric", cylindrical, radial_hoop_axial) + support("low", "y"), geo));
}

}  // namespace
}  // namespace hot_anisotropy_tests
}  // namespace creepcontact::test
