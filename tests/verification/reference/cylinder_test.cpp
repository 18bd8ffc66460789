// Cylinders: the closed forms against published numbers and against what they must fulfil.
#include <gtest/gtest.h>

#include "verification/reference/polynomial.hpp"
#include "verification/reference/sheath_on_pellet.hpp"
#include "verification/reference/thick_cylinder.hpp"

namespace creepcontact::reference {
namespace {

constexpr ThickCylinder nafems_cylinder{100, 200, 200};

TEST(ThickCylinder, PublishedStresses) {
  EXPECT_NEAR(nafems_cylinder.elastic_sigma_theta(100), 333.33, 0.0051);
  EXPECT_NEAR(nafems_cylinder.elastic_sigma_theta(200), 133.33, 0.0051);
  const double r[] = {100, 125, 150, 175, 200}, hoop[] = {130.39, 172.70, 204.58, 229.78, 250.39};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(nafems_cylinder.steady_sigma_theta(r[i], 5), hoop[i], 0.0051) << r[i];
}

TEST(ThickCylinder, FulfilsItsEquations) {
  for (const double n : {1.0, 3.0, 7.0}) {
    EXPECT_NEAR(nafems_cylinder.steady_sigma_r(100, n), -200, 1e-10);
    EXPECT_NEAR(nafems_cylinder.steady_sigma_r(200, n), 0, 1e-10);
    for (const double r : {110.0, 160.0}) {
      const double h = 1e-3, sr = nafems_cylinder.steady_sigma_r(r, n), st = nafems_cylinder.steady_sigma_theta(r, n);
      const double slope =
          (nafems_cylinder.steady_sigma_r(r + h, n) - nafems_cylinder.steady_sigma_r(r - h, n)) / (2 * h);
      EXPECT_NEAR(slope, (st - sr) / r, 1e-7) << "equilibrium";
      EXPECT_NEAR(nafems_cylinder.steady_sigma_z(r, n), 0.5 * (sr + st), 1e-10) << "no creep along the axis";
      EXPECT_NEAR(nafems_cylinder.steady_von_mises(r, n), 0.5 * std::sqrt(3.0) * (st - sr), 1e-10);
      const double A = 1e-14;
      EXPECT_NEAR(nafems_cylinder.steady_displacement_rate(r, A, n) * r,
                  nafems_cylinder.steady_displacement_rate(100, A, n) * 100,
                  1e-12 * nafems_cylinder.steady_displacement_rate(100, A, n) * 100)
          << "no change of volume";
    }
  }
}

TEST(SheathOnPellet, PublishedValues) {
  const SheathOnPellet problem;
  const double p = problem.contact_pressure;
  EXPECT_NEAR(problem.sheath.displacement(p, 2, 0.9), 2.1450e-3, 0.51e-7);
  EXPECT_NEAR(problem.sheath.sigma_theta(p, 2), 6.6667e-4, 0.51e-8);
  EXPECT_NEAR(problem.sheath.sigma_z(p, 0.9), 2.7912e-4, 0.51e-8);
  EXPECT_EQ(problem.sheath.sigma_r(p, 2), 0.0);
  EXPECT_NEAR(problem.sheath.sigma_r(p, 1), -p, 1e-18);
}

TEST(SheathOnPellet, StartsElastic) {
  const ElasticCylinder elastic{1, 2, 1, 0.3};
  const SheathOnPellet problem;
  for (const double r : {1.0, 1.4, 2.0})
    EXPECT_NEAR(problem.sheath.displacement(1e-3, r, 0), elastic.displacement(1e-3, 0, r), 1e-15);
}

TEST(SheathOnPellet, BorePressureClosesTheGapAndBalancesTheContact) {
  const SheathOnPellet problem;
  for (const double t : {0.0, 0.45, 0.9}) {
    const double p1 = problem.bore_pressure(t);
    const double pellet = problem.pellet.displacement(p1, problem.pellet_outer_pressure(), 0.98);
    EXPECT_NEAR(0.98 + pellet, 1 + problem.sheath.displacement(1e-3, 1, t), 1e-14) << t;
    EXPECT_GT(p1, problem.contact_pressure);
  }
}

TEST(GaussRule, IntegratesPolynomialsExactly) {
  for (const int n : {1, 2, 5, 9}) {
    const GaussRule rule = gauss_rule(n);
    const int degree = 2 * n - 2;
    EXPECT_NEAR((rule.weights.array() * rule.points.array().pow(degree)).sum(), 2.0 / (degree + 1), 1e-13) << n;
  }
}

}  // namespace
}  // namespace creepcontact::reference
