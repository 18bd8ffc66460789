// Unified viscoplastic laws under cyclic loads against integrations of the same laws along one axis.

#include <cmath>
#include <functional>

#include "verification/cube.hpp"

namespace creepcontact {
namespace viscoplastic_tests {
namespace {

using namespace test;

constexpr double E = 200e3;  // of the cube

/// A bar of chaboche's law. Under stress along one axis, X = 2/3 C alpha is C alpha along it.
struct Bar {
  double K, n, yield, Q, b;
  std::array<double, 2> C, gamma, recovery{}, exponent{1, 1};
  double sinh_rate = 0;

  using State = std::array<double, 5>;  // inelastic strain, X_1, X_2, R, p

  double flow(double overstress) const {
    if (!(overstress > 0)) return 0;
    return sinh_rate > 0 ? sinh_rate * std::pow(std::sinh(overstress / K), n) : std::pow(overstress / K, n);
  }
  State rate(double stress, const State& y) const {
    const double effective = stress - y[1] - y[2];
    const double dp = flow(std::abs(effective) - yield - y[3]), strain = effective > 0 ? dp : -dp;
    State result{strain, 0, 0, b * (Q - y[3]) * dp, dp};
    for (std::size_t i = 0; i < 2; ++i) {
      const double X = y[1 + i];
      result[1 + i] = C[i] * strain - gamma[i] * X * dp - recovery[i] * std::pow(std::abs(X), exponent[i] - 1) * X;
    }
    return result;
  }
  /// Classical Runge-Kutta from virgin material at t = 0 on. @param stress  of the time and the inelastic strain
  State at(double end, double step, const std::function<double(double, double)>& stress) const {
    State y{};
    const auto n_steps = static_cast<int>(std::lround(end / step));
    const auto moved = [](const State& from, const State& by, double h) {
      State to = from;
      for (std::size_t i = 0; i < to.size(); ++i) to[i] += h * by[i];
      return to;
    };
    const auto f = [&](double t, const State& at) { return rate(stress(t, at[0]), at); };
    for (int k = 0; k < n_steps; ++k) {
      const double t = k * step, half = step / 2;
      const State a = f(t, y), b2 = f(t + half, moved(y, a, half)), c = f(t + half, moved(y, b2, half)),
                  d = f(t + step, moved(y, c, step));
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += step / 6 * (a[i] + 2 * b2[i] + 2 * c[i] + d[i]);
    }
    return y;
  }

  std::string table() const {
    return creep_law_table(
        "chaboche",
        fmt::format("K = {}\nn = {}\nyield = {}\nQ = {}\nb = {}\nC = [{}, {}]\ngamma = [{}, {}]\nrecovery = [{}, "
                    "{}]\nrecovery_exponent = [{}, {}]\nsinh_rate = {}\n",
                    K, n, yield, Q, b, C[0], C[1], gamma[0], gamma[1], recovery[0], recovery[1], exponent[0],
                    exponent[1], sinh_rate));
  }
};

const Bar steel{.K = 150, .n = 12, .yield = 60, .Q = 80, .b = 10, .C = {120e3, 20e3}, .gamma = {1200, 120}};

/// Linear between its points, periodic.
double periodic(double t, const std::vector<double>& times, const std::vector<double>& values) {
  t = std::fmod(t, times.back());
  std::size_t i = 0;
  while (i + 2 < times.size() && t > times[i + 1]) ++i;
  return values[i] + (values[i + 1] - values[i]) * (t - times[i]) / (times[i + 1] - times[i]);
}

void expect_history(const Bar& bar, const std::string& loading, const std::string& output,
                    const std::vector<double>& times, const std::function<double(double, double)>& stress,
                    const std::string& integrator = "auto") {
  const Outcome outcome = run_cube(
      bar.table(), loading,
      fmt::format("end = {}\noutput = {}\ntolerance = 1e-5\nintegrator = \"{}\"\n", times.back(), output, integrator));
  double largest = 0;
  for (const double t : times) largest = std::max(largest, std::abs(outcome.history.at("sxx", t)));
  for (const double t : times) {
    const Bar::State y = bar.at(t, 2e-4, stress);
    EXPECT_NEAR(outcome.history.at("sxx", t), stress(t, y[0]), 2e-4 * largest) << t;
    EXPECT_NEAR(outcome.history.at("cxx", t), y[0], 2e-4 * largest / E) << t;
    EXPECT_NEAR(outcome.history.at("cyy", t), -y[0] / 2, 2e-4 * largest / E) << t;
  }
}

const std::string triangle = support("x1", "x", "{ t = [0, 5, 15, 20], values = [0, 0.6, -0.6, 0], period = 20 }");
const std::string triangle_output = "[5, 10, 15, 20, 25, 35, 40, 45, 55, 60]";
const std::vector<double> triangle_times{5, 10, 15, 20, 25, 35, 40, 45, 55, 60};
double triangle_stress(double t, double inelastic) {
  return E * (periodic(t, {0, 5, 15, 20}, {0, 0.006, -0.006, 0}) - inelastic);
}

class ViscoplasticLoops : public testing::TestWithParam<const char*> {};
TEST_P(ViscoplasticLoops, OfStrainCyclesAreThoseOfABar) {
  expect_history(steel, triangle, triangle_output, triangle_times, triangle_stress, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Integrators, ViscoplasticLoops,
                         testing::Values("auto", "log_adams", "cvode_bdf", "arkode_dirk"),
                         [](const auto& integrator) { return std::string(integrator.param); });

TEST(Viscoplastic, StressRelaxesInHolds) {
  const auto strain = [](double t) { return periodic(t, {0, 1, 21, 22, 42}, {0, 0.005, 0.005, -0.001, -0.001}); };
  expect_history(steel, support("x1", "x", "{ t = [0, 1, 21, 22, 42], values = [0, 0.5, 0.5, -0.1, -0.1] }"),
                 "[1, 2, 5, 21, 22, 30, 42]", {1, 2, 5, 21, 22, 30, 42},
                 [&](double t, double inelastic) { return E * (strain(std::min(t, 41.999999)) - inelastic); });
}

TEST(Viscoplastic, StrainRatchetsUnderUnsymmetricStress) {
  const auto stress = [](double t, double) { return periodic(t, {0, 5, 15, 20}, {60, 260, -140, 60}); };
  const std::string load = pulled("{ t = [0, 5, 15, 20], values = [60, 260, -140, 60], period = 20 }");
  expect_history(steel, load, "{ first = 20, count = 6 }", {20, 40, 60, 80, 100, 120}, stress);
  const double second = steel.at(40, 2e-4, stress)[0], sixth = steel.at(120, 2e-4, stress)[0];
  EXPECT_GT(sixth, second + 1e-4);  // it does ratchet
}

TEST(Viscoplastic, StaticRecoverySoftensBetweenCycles) {
  Bar recovering = steel;
  recovering.recovery = {0.02, 1e-4};
  recovering.exponent = {1, 2};
  expect_history(recovering, triangle, triangle_output, triangle_times, triangle_stress);
}

TEST(Viscoplastic, OverstressInASinh) {
  Bar sinh = steel;
  sinh.sinh_rate = 1e-5;
  sinh.K = 40;
  sinh.n = 2;
  expect_history(sinh, triangle, triangle_output, triangle_times, triangle_stress);
}

TEST(Viscoplastic, CyclicSofteningLowersTheStress) {
  Bar softening = steel;
  softening.Q = -40;
  softening.b = 30;
  expect_history(softening, triangle, triangle_output, triangle_times, triangle_stress);
}

/// A bar of anand's law: stress from a strain that grows evenly up to `turn` and then back.
double anand_stress(double end, double turn, double strain_rate) {
  const double A = 30, xi = 2, m = 0.3, s_hat = 60, n = 0.02, h0 = 900, a = 1.3;
  const auto f = [&](double t, const std::array<double, 2>& y) {  // inelastic strain, s
    const double stress = E * (strain_rate * std::min(t, 2 * turn - t) - y[0]);
    const double relative = std::pow(std::sinh(xi * std::abs(stress) / y[1]), 1 / m);
    const double rest = 1 - y[1] / (s_hat * std::pow(std::max(relative, 1e-300), n));
    const double flow = A * relative;
    return std::array<double, 2>{stress > 0 ? flow : -flow,
                                 h0 * std::pow(std::abs(rest), a) * (rest > 0 ? 1 : -1) * flow};
  };
  std::array<double, 2> y{0, 25};
  const double h = 2e-5;
  const auto moved = [](const auto& from, const auto& by, double step) {
    return std::array<double, 2>{from[0] + step * by[0], from[1] + step * by[1]};
  };
  for (int k = 0; k < std::lround(end / h); ++k) {
    const double t = k * h;
    const auto k1 = f(t, y), k2 = f(t + h / 2, moved(y, k1, h / 2)), k3 = f(t + h / 2, moved(y, k2, h / 2)),
               k4 = f(t + h, moved(y, k3, h));
    for (std::size_t i = 0; i < 2; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return E * (strain_rate * std::min(end, 2 * turn - end) - y[0]);
}

/// Hardly any overstress: relaxation takes 5e-9 of the run. The stress is that of plasticity which does not depend on
/// the rate, yield + Q (1 - exp(-b p)) + C/gamma (1 - exp(-gamma p)).
TEST(Viscoplastic, AutoFindsTheStiffWay) {
  const Outcome outcome =
      run_cube(creep_law_table("chaboche", "K = 1e-3\nn = 1\nyield = 100\nQ = 50\nb = 10\nC = [20e3]\ngamma = [200]\n"),
               support("x1", "x", "\"0.5*t\""), "end = 1\noutput = [0.1, 0.5, 1]\n");
  EXPECT_LT(outcome.summary.number("steps"), 1000);
  const auto stress = [](double p) { return 100 + 50 * (1 - std::exp(-10 * p)) + 100 * (1 - std::exp(-200 * p)); };
  for (const double t : {0.1, 0.5, 1.0}) {
    const double strain = 0.005 * t;
    double p = 0;
    for (double half = strain; half > 1e-17; half /= 2)
      if (stress(p + half / 2) / E + p + half / 2 < strain) p += half / 2;
    EXPECT_NEAR(outcome.history.at("sxx", t), std::min(E * strain, stress(p)), 0.02) << t;
    EXPECT_NEAR(outcome.history.at("cxx", t), p, 1e-7) << t;
  }
}

/// The same where the load is prescribed: beyond the yield stress the overstress is K C times the rate of the load,
/// 5e-10 of the yield stress, which is far less than what Newton's iterations may leave.
TEST(Viscoplastic, AutoFindsTheStiffWayUnderAPressure) {
  const double end = 1000, yield = 100, C = 20e3, highest = 110;
  for (const double gamma : {0.0, 200.0}) {
    const std::string law = creep_law_table(
        "chaboche", fmt::format("K = 1e-3\nn = 1\nyield = {}\nC = [{}]\ngamma = [{}]\n", yield, C, gamma));
    const std::string ramp =
        fmt::format("\n[[loads]]\non = \"x1\"\npressure = {{ t = [0, {}], values = [0, {}] }}\n", end, highest);
    const std::string time = fmt::format("end = {}\noutput = [500, {}]\n", end, end);
    const double hardening = highest - yield;
    const double strain = gamma > 0 ? -std::log(1 - gamma * hardening / C) / gamma : hardening / C;
    for (const char* method : {"", "integrator = \"cvode_bdf\"\nlinear_solver = \"tangent\"\n"}) {
      const Outcome outcome = run_cube(law, ramp, time + method);
      // 80 to 434 steps as the last bits fall; above 60 000 where the tangent is not renewed.
      EXPECT_LT(outcome.summary.number("steps"), 1000) << gamma << method;
      EXPECT_LT(outcome.summary.number("elastic_solves"), 6000) << gamma << method;
      EXPECT_NEAR(outcome.history.at("cxx", end), -strain, 5e-7) << gamma << method;
    }
  }
}

TEST(Viscoplastic, AnandHardensAtConstantRateAndFlowsBack) {
  const Outcome outcome =
      run_cube(creep_law_table("anand", "A = 30\nxi = 2\nm = 0.3\ns_hat = 60\nn = 0.02\nh0 = 900\na = 1.3\ns0 = 25\n"),
               support("x1", "x", "{ t = [0, 2, 3], values = [0, 4, 2] }"),
               "end = 3\noutput = [0.1, 0.5, 1, 2, 2.5, 3]\ntolerance = 1e-5\n");
  double before = 0;
  for (const double t : {0.1, 0.5, 1.0, 2.0}) {
    const double now = anand_stress(t, 2, 0.02);
    EXPECT_RELATIVE(outcome.history.at("sxx", t), now, 3e-4);
    EXPECT_GT(now, before);
    before = now;
  }
  for (const double t : {2.5, 3.0}) EXPECT_RELATIVE(outcome.history.at("sxx", t), anand_stress(t, 2, 0.02), 3e-4);
}

/// eps^((n+m)/m) = (n+m)/m (q/K)^n t
TEST(Viscoplastic, LemaitreCreepsAsItsClosedForm) {
  const Outcome outcome = run_cube(creep_law_table("lemaitre", "K = 1500\nn = 8\nm = 6\n"), pulled("120"),
                                   "end = 100\noutput = [1, 10, 100]\ntolerance = 1e-6\n");
  for (const double t : {1.0, 10.0, 100.0})
    EXPECT_RELATIVE(outcome.history.at("cxx", t), std::pow(14.0 / 6 * std::pow(120.0 / 1500, 8) * t, 6.0 / 14), 1e-5);
}

}  // namespace
}  // namespace viscoplastic_tests
}  // namespace creepcontact
