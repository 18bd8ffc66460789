/// Creep and plasticity in one in the lower block, which is pressed and let go again: strain in one direction that
/// opens the contact for a part of each cycle, by every integrator, against an integration along the axis.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

constexpr double K = 0.4, n = 5, yield = 0.3, Q = 0.1, b = 40, C = 40, gamma = 150, recovery = 0.2;
constexpr double period = 4, closed = 0.025, open = 0.008;

const std::vector<std::string> viscoplastic{
    fmt::format("materials.soft.creep=[{{law='chaboche', K={}, n={}, yield={}, Q={}, b={}, C=[{}], gamma=[{}], "
                "recovery=[{}]}}]",
                K, n, yield, Q, b, C, gamma, recovery),
    "materials.hard.creep.0.A=0",
    fmt::format("supports.3.displacement.z={{t=[0, 1, 3, {0}], values=[-{1}, -{1}, -{2}, -{1}], period={0}}}", period,
                closed, open),
    "time.end=12", "output.fields=false"};

/// How far the top is down at a time.
using Push = double (*)(double t);

double to_and_fro(double t) {
  t = std::fmod(t, period);
  if (t < 1) return closed;
  return t < 3 ? closed + (t - 1) / 2 * (open - closed) : open + (t - 3) * (closed - open);
}

/// Pressure, from the shortening of the lower block by creep.
double pressure(Push push, double t, double strain) {
  return std::max(0.0, (push(t) - 2 * strain) / 0.025);
}

using State = std::array<double, 3>;  // along the axis: strain, back stress, R/Q; compression is positive

State rate(Push push, double t, const State& y) {
  const double effective = pressure(push, t, y[0]) - y[1], over = std::abs(effective) - yield - Q * y[2];
  const double dp = over > 0 ? std::pow(over / K, n) : 0, strain = effective > 0 ? dp : -dp;
  return {strain, C * strain - gamma * y[1] * dp - recovery * y[1], b * (1 - y[2]) * dp};
}

/// At all multiples of 0.1 up to 12, by the classical Runge-Kutta method.
std::vector<double> reference_pressures(Push push) {
  constexpr int steps_per_tenth = 10000;
  constexpr double step = 0.1 / steps_per_tenth;
  State y{};
  std::vector<double> pressures{pressure(push, 0, 0)};
  const auto moved = [](State from, const State& by, double h) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] += h * by[i];
    return from;
  };
  for (int k = 0; k < 120 * steps_per_tenth; ++k) {
    const double t = k * step;
    const State r1 = rate(push, t, y), r2 = rate(push, t + step / 2, moved(y, r1, step / 2)),
                r3 = rate(push, t + step / 2, moved(y, r2, step / 2)), r4 = rate(push, t + step, moved(y, r3, step));
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += step / 6 * (r1[i] + 2 * r2[i] + 2 * r3[i] + r4[i]);
    if ((k + 1) % steps_per_tenth == 0) pressures.push_back(pressure(push, (k + 1) * step, y[0]));
  }
  return pressures;
}

class ViscoplasticIntegrators : public testing::TestWithParam<std::string> {};

TEST_P(ViscoplasticIntegrators, OpensAndClosesAsAlongTheAxis) {
  const Case blocks;
  std::vector<std::string> overrides = viscoplastic;
  overrides.insert(overrides.end(), {"time.output=[0.3, 1, 2, 3, 4, 5, 7, 8, 9, 11]", "time.tolerance=1e-5",
                                     "time.step=adaptive", "time.integrator=" + GetParam()});
  ASSERT_EQ(run(blocks.config(pressure_probe, overrides), {.output = (blocks / "out").string()}).exit_status, 0);
  const Table history(blocks / "out" / "history.csv");
  static const std::vector<double> reference = reference_pressures(to_and_fro);
  double smallest = 1;
  for (const double t : history.times()) {
    EXPECT_NEAR(history.at("pressure", t), reference.at(static_cast<std::size_t>(std::lround(10 * t))), 2e-4) << t;
    smallest = std::min(smallest, history.at("pressure", t));
  }
  EXPECT_EQ(smallest, 0) << "the contact opens";
}

/// At the breakpoints the lower block is elastic, so that nothing flows there; the upper one creeps a little all the
/// time.
TEST(ViscoplasticContact, YieldingBetweenElasticStatesIsNotPassedOver) {
  const Push swell = [](double t) { return 0.005 + 0.02 * std::pow(std::sin(t * std::numbers::pi / 6), 2); };
  const double expected = reference_pressures(swell).back();
  for (const char* integrator : {"log_adams", "cvode_bdf", "arkode_erk"}) {
    const Case blocks;
    std::vector<std::string> overrides = viscoplastic;
    overrides.insert(overrides.end(), {"supports.3.displacement.z='-0.005 - 0.02*sin(pi*t/6)^2'",
                                       "time.breakpoints=[6]", "materials.hard.creep.0.A=1e-9", "time.tolerance=1e-4",
                                       std::string("time.integrator=") + integrator});
    ASSERT_EQ(run(blocks.config(pressure_probe, overrides), {.output = (blocks / "out").string()}).exit_status, 0);
    EXPECT_NEAR(Table(blocks / "out" / "history.csv").at("pressure", 12), expected, 1e-3) << integrator;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, ViscoplasticIntegrators,
                         testing::Values("auto", "log_adams", "cvode_bdf", "cvode_adams", "arkode_erk", "arkode_dirk",
                                         "beta_euler"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace creepcontact::run::test
