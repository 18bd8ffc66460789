#include "verification/reference/ring_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "verification/reference/relaxation.hpp"
#include "verification/reference/sheath_on_pellet.hpp"
#include "verification/reference/thick_cylinder.hpp"

namespace creepcontact::reference {
namespace {

constexpr double ri = 50, R = 100, ro = 180, delta = 0.1;
constexpr Ring shaft{ri, R, 2.06e5, 0.3, 1e-20, 7};
constexpr Ring disc{R, ro, 1.8e5, 0.28, 4e-20, 6.5};

TEST(RingFit, ElasticPressureIsLames) {
  const double E = 2e5, nu = 0.3;
  const Ring inside{ri, R, E, nu, 0, 1}, outside{R, ro, E, nu, 0, 1};
  const double plane_stress = E * delta / (2 * R * R * R) * (ro * ro - R * R) * (R * R - ri * ri) / (ro * ro - ri * ri);
  EXPECT_NEAR(RingFit(inside, outside, delta, Plane::stress).elastic_pressure(), plane_stress, 1e-9 * plane_stress);
  const double plane_strain = plane_stress / (1 - nu * nu);
  EXPECT_NEAR(RingFit(inside, outside, delta, Plane::strain).elastic_pressure(), plane_strain, 1e-9 * plane_strain);
}

TEST(RingFit, ElasticRingsKeepTheirPressure) {
  const Ring inside{ri, R, 2e5, 0.3, 0, 1}, outside{R, ro, 2e5, 0.3, 0, 1};
  const RingFit fit(inside, outside, delta, Plane::strain);
  EXPECT_DOUBLE_EQ(fit.pressure({1e5})[0], fit.elastic_pressure());
}

/// Radial displacement at R over R, per unit pressure and compliance, of the outer (+) and inner ring (-), plane
/// stress.
double lame_factor(const Ring& ring, double nu) {
  const double a = ring.inner * ring.inner, b = ring.outer * ring.outer;
  return (b + a) / (b - a) + (ring.inner == R ? nu : -nu);
}

TEST(RingFit, LinearCreepInPlaneStressDecaysExponentially) {
  // n = 1: Lame's stresses stay, the creep part of the displacement is Lame's with 1/E -> A and nu -> 1/2.
  const Ring inside{ri, R, 2.06e5, 0.3, 1e-9, 1}, outside{R, ro, 1.5e5, 0.35, 3e-9, 1};
  const double elastic = lame_factor(inside, 0.3) / 2.06e5 + lame_factor(outside, 0.35) / 1.5e5;
  const double creep = lame_factor(inside, 0.5) * 1e-9 + lame_factor(outside, 0.5) * 3e-9;
  const std::vector<double> times{100, 1000, 5000, 20000};
  const auto p = RingFit(inside, outside, delta, Plane::stress).pressure(times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double exact = delta / R / elastic * std::exp(-creep / elastic * times[i]);
    EXPECT_NEAR(p[i], exact, 1e-7 * exact) << times[i];
  }
}

TEST(RingFit, LinearCreepInPlaneStrainFollowsFromTheSheathUnderPressure) {
  // n = 1, one material: the fit is the superposition of pressure steps on the creeping cylinder of SSNA105,
  // interference = J(0) p + b z + c integral p, z' = k (p - z), k = E A.
  const double E = 2e5, nu = 0.3, A = 2e-9, k = E * A;
  const Ring inside{ri, R, E, nu, A, 1}, outside{R, ro, E, nu, A, 1};
  const CreepingCylinder outer{R, ro, E, nu, A}, inner{R, ri, E, nu, A};  // the pressed radius first
  const auto opening = [&](double t) { return outer.displacement(1, R, t) - inner.displacement(1, R, t); };
  const double J0 = opening(0), late = opening(100 / k), later = opening(200 / k);
  const double c = (later - late) / (100 / k), b = late - c * 100 / k - J0;
  Eigen::Matrix2d M;
  M << -(c + b * k) / J0, b * k / J0, k, -k;
  // Both eigenvalues are real, for the coefficients off the diagonal have one sign.
  const double mean = M.trace() / 2, half = std::sqrt(mean * mean - M.determinant());
  const std::vector<double> times{100, 1000, 5000, 20000};
  const auto p = RingFit(inside, outside, delta, Plane::strain).pressure(times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double fast = std::exp((mean - half) * times[i]), slow = std::exp((mean + half) * times[i]);
    const double exact = (slow * (M(0, 0) - mean + half) - fast * (M(0, 0) - mean - half)) / (2 * half) * delta / J0;
    EXPECT_NEAR(p[i], exact, 1e-7 * exact) << times[i];
  }
}

class RingFitConvergence : public testing::TestWithParam<Plane> {};

TEST_P(RingFitConvergence, HalvingMeshAndToleranceChangesNothing) {
  const std::vector<double> times{1, 10, 100, 1000, 1e4, 1e5, 1e6};
  const auto coarse = RingFit(shaft, disc, delta, GetParam()).pressure(times);
  const auto fine = RingFit(shaft, disc, delta, GetParam(), {4, 7, 1e-10}).pressure(times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(coarse[i], fine[i], 1e-6 * fine[i]) << times[i];
    EXPECT_LT(fine[i], i == 0 ? RingFit(shaft, disc, delta, GetParam()).elastic_pressure() : fine[i - 1]);
  }
}
INSTANTIATE_TEST_SUITE_P(Planes, RingFitConvergence, testing::Values(Plane::strain, Plane::stress));

TEST(RingFit, ThinRingsRelaxLikeBarsInSeries) {
  // Thickness h much below R, plane stress: hoop stresses -p R / h and p R / h alone, each ring in uniaxial creep.
  // What is left out is of the size h / R. One element of low degree: more would add nothing but rounding.
  const double h = 1e-4 * R, E1 = 2e5, E2 = 1.5e5, A1 = 1e-20, A2 = 3e-20, n = 7;
  const RingFit fit({R - h, R, E1, 0.3, A1, n}, {R, R + h, E2, 0.3, A2, n}, 0.1, Plane::stress, {1, 2, 1e-9});
  for (const double t : {1.0, 1e3, 1e6, 1e9}) {
    const double stress = blocks_in_series({R, E1, A1}, {R, E2, A2}, n, 0.1 / (R / E1 + R / E2), t);
    EXPECT_NEAR(fit.pressure({t})[0] * R / h, stress, 3e-5 * stress) << t;
  }
}

TEST(RingFit, RingOnASoftElasticCoreOpensLikeTheThickCylinderInItsSteadyState) {
  // The core is soft enough to keep its pressure; what it loses in a while is the creep of the bore over its
  // compliance.
  const double n = 5, A = 3.125e-14, E = 0.1, nu = 0.3;
  const ElasticCylinder core{50, 100, E, nu};
  const double compliance = -core.displacement(0, 1, 100);
  const RingFit fit({50, 100, E, nu, 0, 1}, {100, 200, 2e5, 0.3, A, n}, 200 * compliance, Plane::strain, {2, 7, 1e-11});
  const auto p = fit.pressure({2, 3});
  const double rate = ThickCylinder{100, 200, 0.5 * (p[0] + p[1])}.steady_displacement_rate(100, A, n);
  EXPECT_NEAR((p[0] - p[1]) * compliance, rate, 1e-5 * rate);
}

TEST(RingFit, OneElasticRingStillLosesItsPressure) {
  const Ring elastic{ri, R, 2e5, 0.3, 0, 1}, creeping{R, ro, 2e5, 0.3, 1e-20, 7};
  const auto p = RingFit(elastic, creeping, delta, Plane::strain).pressure({1e4});
  const auto both = RingFit({ri, R, 2e5, 0.3, 1e-20, 7}, creeping, delta, Plane::strain).pressure({1e4});
  EXPECT_LT(p[0], RingFit(elastic, creeping, delta, Plane::strain).elastic_pressure());
  EXPECT_GT(p[0], both[0]);
}

}  // namespace
}  // namespace creepcontact::reference
