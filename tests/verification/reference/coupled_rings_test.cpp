#include "verification/reference/coupled_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/reference/ring_fit.hpp"

namespace creepcontact::reference {
namespace {

constexpr double E = 1.75e5, nu = 0.3, alpha = 1.2e-5, k = 35;

CoupledRings rings(double A, double fluid_at_bore, double fluid_at_rim) {
  return {.bore = 30,
          .fit = 60,
          .rim = 120,
          .interference = 0.055,
          .assembly_temperature = 20,
          .young_modulus = E,
          .poisson_ratio = nu,
          .expansion = alpha,
          .A = A,
          .n = 5,
          .A_growth = 0.015,
          .A_temperature = 20,
          .conductivity = k,
          .capacity = 4.29,
          .time_unit = 3600,
          .ramp = 4,
          .at_bore = {{0.1, 5}, {20, fluid_at_bore}},
          .at_rim = {{0.1, 5}, {20, fluid_at_rim}},
          .joint = {.gas = 0.2, .gas_gap = 5e-3, .solid = 3, .solid_pressure = 50, .linear_below = 0.02}};
}

TEST(CoupledRings, UnheatedRelaxLikeTheRingFit) {
  const Ring inside{30, 60, E, nu, 1e-16, 5}, outside{60, 120, E, nu, 1e-16, 5};
  const std::vector<double> times{1, 100, 1e4, 1e5};
  const auto expected = RingFit(inside, outside, 0.055, Plane::stress).pressure(times);
  CoupledRingsHistory history(rings(1e-16, 20, 20));
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(history.at(times[i]).pressure, expected[i], 1e-6 * expected[i]) << times[i];
}

/// Without creep: heat through films, rings and joint in series, and the difference of the mean temperatures, whose
/// expansion takes part in the interference.
TEST(CoupledRings, ElasticRingsReachTheSteadyState) {
  for (const double at_rim : {100.0, 650.0}) {  // closed, open
    const CoupledRings of = rings(0, 500, at_rim);
    const auto found = CoupledRingsHistory(of).at(1e3);
    EXPECT_EQ(found.gap > 0, at_rim > 500);
    const double h = of.joint.value(found.pressure, found.gap);
    const double inner = std::log(of.fit / of.bore) / k, outer = std::log(of.rim / of.fit) / k;
    const double Q = (500 - at_rim) / (1 / (5 * of.bore) + inner + 1 / (h * of.fit) + outer + 1 / (5 * of.rim));
    const double bore = 500 - Q / (5 * of.bore), rim = at_rim + Q / (5 * of.rim);
    EXPECT_NEAR(found.bore, bore, 1e-4);
    EXPECT_NEAR(found.inner_face, bore - Q * inner, 1e-4);
    EXPECT_NEAR(found.outer_face, rim + Q * outer, 1e-4);
    EXPECT_NEAR(found.rim, rim, 1e-4);
    // Mean over the area of T = T_a - Q/k ln(r/a) between a and b.
    const auto mean = [&](double a, double b, double T_a) {
      return T_a - Q / k * (b * b * std::log(b / a) / (b * b - a * a) - 0.5);
    };
    const double difference = mean(of.bore, of.fit, found.bore) - mean(of.fit, of.rim, found.outer_face);
    const double interference = of.interference + alpha * of.fit * difference;
    const double a = of.bore * of.bore, R = of.fit * of.fit, b = of.rim * of.rim;
    const double stiffness = E * (b - R) * (R - a) / (2 * R * of.fit * (b - a));  // Lame
    EXPECT_NEAR(found.pressure, std::max(0.0, stiffness * interference), 1e-4);
    EXPECT_NEAR(found.gap, std::max(0.0, -interference), 1e-7);
  }
}

TEST(CoupledRings, DegreeAndToleranceChangeNothing) {
  for (const double at_rim : {450.0, 650.0}) {
    CoupledRings of = rings(1e-16, 550, at_rim);
    of.A_temperature = 500;
    CoupledRingsHistory coarse(of), fine(of, 14, 1e-9);
    for (const double t : {0.5, 2.0, 4.0, 6.0, 100.0, 1e4}) {
      const auto a = coarse.at(t), b = fine.at(t);
      EXPECT_NEAR(a.pressure, b.pressure, 1e-4) << at_rim << ' ' << t;
      EXPECT_NEAR(a.gap, b.gap, 1e-7) << at_rim << ' ' << t;
      EXPECT_NEAR(a.inner_face, b.inner_face, 2e-4) << at_rim << ' ' << t;
      EXPECT_NEAR(a.outer_face, b.outer_face, 2e-4) << at_rim << ' ' << t;
    }
  }
}

}  // namespace
}  // namespace creepcontact::reference
