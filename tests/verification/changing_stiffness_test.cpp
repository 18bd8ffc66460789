/// Elastic constants that follow a temperature that changes in time: held bars, a shrink fit that loosens as it heats,
/// and histories that must not depend on how often the stiffness is factored.

#include <fmt/format.h>

#include "boxes.hpp"
#include "case.hpp"
#include "rings.hpp"
#include "verification/reference/ring_fit.hpp"

namespace creepcontact::test {
namespace {

// Constants of the bar at the temperature 20 + rise.
double bar_modulus(double rise) {
  return 2e5 * (1 - 4e-4 * rise);
}
double bar_expansion(double rise) {
  return 1.2e-5 + 4e-9 * rise;
}
constexpr double bar_A = 1e-17, bar_n = 5;

/// Held at both ends, free at its sides.
std::string held_bar(const std::string& temperature, bool creeps) {
  std::string toml = R"(
    [mesh]
    file = "case.geo"
    order = 1
    [bodies.bar]
    region = "bar"
    material = "steel"
    [materials.steel]
    young_modulus = '2e5*(1 - 4e-4*(T - 20))'
    poisson_ratio = '0.3 + 2e-4*(T - 20)'
    thermal_expansion = '1.2e-5 + 4e-9*(T - 20)'
    reference_temperature = 20
  )";
  if (creeps) toml += fmt::format("[[materials.steel.creep]]\nlaw = \"norton\"\nA = {}\nn = {}\n", bar_A, bar_n);
  return toml + support("bar_x0", "x") + support("bar_y0", "y") + support("bar_z0", "z") + support("bar_z1", "z") +
         "[temperature]\nvalue = \"" + temperature + "\"\nrefactor_change = 0.3\n" +
         probe("stress", "stress_zz", "body = \"bar\"") +
         probe("stress_x", "stress_xx", "body = \"bar\"\nreduce = \"max\"");
}

const std::vector<Box> bar{{"bar", {0, 0, 0}, {1, 1, 4}, {1, 1, 4}}};

TEST(HeldBar, IsPressedByTheModulusOfTheMoment) {
  const Outcome outcome =
      run_case(held_bar("20 + 3*t", false) + "[time]\nend = 100\noutput = [25, 50, 100]\n", boxes_geo(bar));
  for (const double t : {25.0, 50.0, 100.0}) {
    const double rise = 3 * t, exact = -bar_modulus(rise) * bar_expansion(rise) * rise;
    EXPECT_RELATIVE(outcome.history.at("stress", t), exact, 1e-9);
    EXPECT_NEAR(outcome.history.at("stress_x", t), 0, 1e-9 * std::abs(exact));
  }
  EXPECT_EQ(outcome.summary.number("factorizations"), 1);
  EXPECT_GT(outcome.summary.number("elastic_solves"), 4) << "bulk and shear modulus change by different factors";
}

/// sigma = E(T) (-alpha(T) (T - 20) - eps_c), d(eps_c)/dt = A |sigma|^(n-1) sigma, by the Runge-Kutta method of
/// order 4.
TEST(HeldBar, RelaxesWhileItIsHeatedAndCooled) {
  const auto stress = [](double t, double creep) {
    const double rise = 150 * (1 - std::cos(0.1 * t));
    return bar_modulus(rise) * (-bar_expansion(rise) * rise - creep);
  };
  const auto rate = [&](double t, double creep) {
    const double sigma = stress(t, creep);
    return bar_A * std::pow(std::abs(sigma), bar_n - 1) * sigma;
  };
  const double end = 100, h = 1e-3;
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
  const Outcome outcome =
      run_case(held_bar("20 + 150*(1 - cos(0.1*t))", true) +
                   "[time]\nend = 100\ntolerance = 1e-6\noutput = [10, 20, 30, 40, 50, 60, 70, 80, 90, 100]\n",
               boxes_geo(bar));
  for (int i = 1; i <= 10; ++i) EXPECT_NEAR(outcome.history.at("stress", i * end / 10), exact[i], 1e-5 * largest);
  EXPECT_GT(*std::max_element(exact.begin(), exact.end()), 0.1 * largest) << "what crept in the heat pulls in the cold";
}

/// Shaft and hub with constants of their own at the temperature 20 + rise.
struct HotFit {
  const std::vector<RingMesh> rings{{"shaft", 20, 50, 6, 11}, {"hub", 50, 100, 8, 9}};
  std::string bodies = R"(
    [mesh]
    file = "case.geo"
    order = 2
    [bodies.shaft]
    region = "shaft"
    material = "shaft"
    [bodies.hub]
    region = "hub"
    material = "hub"
    [materials.shaft]
    young_modulus = '2.1e5*(1 - 3e-4*(T - 20))'
    poisson_ratio = 0.3
    thermal_expansion = 1.1e-5
    reference_temperature = 20
    [materials.hub]
    young_modulus = '1.9e5*(1 - 6e-4*(T - 20))'
    poisson_ratio = '0.28 + 1e-4*(T - 20)'
    thermal_expansion = '1.8e-5 + 1e-9*(T - 20)'
    reference_temperature = 20
  )";

  static double interference(double rise) { return 0.05 + (1.1e-5 - 1.8e-5 - 1e-9 * rise) * rise * 50; }
  static double pressure(double rise) {
    return reference::RingFit({20, 50, 2.1e5 * (1 - 3e-4 * rise), 0.3, 0, 1},
                              {50, 100, 1.9e5 * (1 - 6e-4 * rise), 0.28 + 1e-4 * rise, 0, 1}, interference(rise),
                              reference::Plane::stress)
        .elastic_pressure();
  }
};

TEST(HotShrinkFit, LoosensSeparatesAndClosesAgain) {
  const HotFit fit;
  const std::vector<double> times{0.1, 0.2, 0.4, 1, 1.6, 1.8, 2};
  for (const double bound : {0.0, 0.05, 0.5}) {
    const Outcome outcome = run_case(
        fit.bodies + ring_supports(fit.rings, false) + contact_table("shaft_outer", "hub_inner", "gap = -0.05") +
            fmt::format("[temperature]\nvalue = \"20 + 200*t*(2 - t)\"\nrefactor_change = {}\n", bound) +
            "[time]\nend = 2\noutput = [0.1, 0.2, 0.4, 1, 1.6, 1.8, 2]\n" +
            probe("pressure", "contact_pressure", "on = \"shaft_outer\"") +
            probe("gap", "gap", "on = \"shaft_outer\"") + probe("force", "contact_force_x", "on = \"hub_inner\""),
        rings_geo(fit.rings, 4));
    const double cold = outcome.history.at("pressure", 0);
    EXPECT_RELATIVE(cold, HotFit::pressure(0), 5e-3);
    for (const double t : times) {
      const double rise = 200 * t * (2 - t);
      const double pressure = outcome.history.at("pressure", t);
      if (HotFit::interference(rise) > 0) {
        // The mesh's part of the error is that of the cold fit.
        EXPECT_RELATIVE(pressure, HotFit::pressure(rise), 5e-3);
        EXPECT_RELATIVE(pressure / cold, HotFit::pressure(rise) / HotFit::pressure(0), 1e-4);
        EXPECT_RELATIVE(outcome.history.at("force", t), pressure * 50 * 4, 1e-3);
      } else {
        EXPECT_NEAR(pressure, 0, 1e-9 * cold);
        EXPECT_RELATIVE(outcome.history.at("gap", t), -HotFit::interference(rise), 1e-3);
      }
    }
    EXPECT_LT(HotFit::interference(200), 0) << "it must separate";
  }
}

/// Heated from the bore, both rings creeping; contact is lost and found again.
std::string graded_fit(const std::string& more) {
  HotFit fit;
  std::string toml = fit.bodies;
  for (const char* name : {"shaft", "hub"})
    toml += fmt::format("[[materials.{}.creep]]\nlaw = \"norton\"\nA = \"1e-16*exp(0.01*(T - 20))\"\nn = 4\n", name);
  return toml + contact_table("shaft_outer", "hub_inner", "gap = -0.05") +
         "[temperature]\nvalue = \"20 + 300*(1 - cos(0.02*t))/2*(1.2 - 0.005*(x^2 + y^2)^0.5)\"\n"
         "[time]\nend = 400\noutput = [20, 50, 100, 150, 200, 250, 300, 350, 400]\n" +
         probe("pressure", "contact_pressure", "on = \"shaft_outer\"") +
         probe("hoop", "stress_theta", "at = [50, 0, 2]\nbody = \"hub\"") +
         probe("moved", "displacement_x", "at = [100, 0, 2]\nbody = \"hub\"") + more;
}

void expect_equal_histories(const Table& found, const Table& expected, double tolerance) {
  ASSERT_EQ(found.rows(), expected.rows());
  for (const std::string& name : expected.names()) {
    const std::vector<double>& values = expected.column(name);
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(found.column(name)[i], values[i], tolerance * largest) << name << " at t = " << expected.times()[i];
  }
}

class GradedFit : public testing::TestWithParam<const char*> {};

TEST_P(GradedFit, HasTheSameHistoryHoweverOftenItsStiffnessIsFactored) {
  const std::vector<RingMesh> rings{{"shaft", 20, 50, 3, 5}, {"hub", 50, 100, 4, 4}};
  const std::string toml = graded_fit(ring_supports(rings, true));
  const auto run = [&](double bound, double tolerance) {
    return run_case(toml, rings_geo(rings, 4),
                    {fmt::format("temperature.refactor_change={}", bound), fmt::format("time.tolerance={}", tolerance),
                     GetParam()});
  };
  const Outcome expected = run(0.05, 1e-7);
  EXPECT_LT(expected.history.at("pressure", 150), 1e-9 * expected.history.at("pressure", 0)) << "contact must be lost";
  EXPECT_GT(expected.history.at("pressure", 300), 0.05 * expected.history.at("pressure", 0)) << "and found again";
  for (const double bound : {0.001, 0.3}) {
    const Outcome outcome = run(bound, 1e-7);
    expect_equal_histories(outcome.history, expected.history, 1e-6);
    EXPECT_EQ(outcome.summary.number("convergence_failures"), 0);
    if (bound == 0.3)
      EXPECT_LE(outcome.summary.number("factorizations"), expected.summary.number("factorizations"));
    else
      EXPECT_GT(outcome.summary.number("factorizations"), expected.summary.number("factorizations"));
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, GradedFit, testing::Values("time.linear_solver=krylov", "time.linear_solver=tangent"),
                         [](const auto& tested) { return std::string(tested.param).substr(19); });

}  // namespace
}  // namespace creepcontact::test
