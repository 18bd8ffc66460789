// Orthotropic elasticity and Hill's transformation.
#include "creepcontact/material/anisotropy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/material/material.hpp"

namespace creepcontact::material {
namespace anisotropy_tests {
namespace {

const Orthotropy alloy{{200e3, 150e3, 120e3}, {0.25, 0.3, 0.35}, {70e3, 50e3, 60e3}};
const Tensor6 some = (Tensor6() << 120, -40, 75, 30, -55, 20).finished();

TEST(Orthotropy, StiffnessInvertsHookesLaw) {
  const Tensor6 strain = alloy.stiffness(0).inverse() * some;
  EXPECT_NEAR(strain[0], (120 - 0.25 * -40 - 0.35 * 75) / 200e3, 1e-15);
  EXPECT_NEAR(strain[1], -0.25 * 120 / 200e3 + -40 / 150e3 - 0.3 * 75 / 150e3, 1e-15);
  EXPECT_NEAR(strain[2], -0.35 * 120 / 200e3 - 0.3 * -40 / 150e3 + 75 / 120e3, 1e-15);
  // Components of shear are sqrt(2) times those of the tensors: strain = stress/(2 G).
  EXPECT_NEAR(strain[3], 30 / 140e3, 1e-15);
  EXPECT_NEAR(strain[4], -55 / 100e3, 1e-15);
  EXPECT_NEAR(strain[5], 20 / 120e3, 1e-15);
}

TEST(Orthotropy, WithEqualConstantsIsIsotropic) {
  const double E = 210e3, nu = 0.3, G = E / (2 * (1 + nu));
  const Orthotropy same{{E, E, E}, {nu, nu, nu}, {G, G, G}};
  EXPECT_LT((same.stiffness(0) * some - stress(lame(E, nu), some)).norm(), 1e-10 * E * some.norm());
  EXPECT_NEAR(same.average_young_modulus()({}), E, 1e-9 * E);
  EXPECT_NEAR(same.average_poisson_ratio()({}), nu, 1e-12);
}

TEST(Orthotropy, AveragesLieWithinTheConstants) {
  const double E = alloy.average_young_modulus()({});
  EXPECT_GT(E, 120e3);
  EXPECT_LT(E, 200e3);
  Orthotropy hot = alloy;
  hot.young_moduli[0] = Function::expression("200e3*(1 - T/2000)", {"T"});
  EXPECT_NEAR(hot.average_young_modulus()({.T = 0}), E, 1e-9 * E);
  EXPECT_LT(hot.average_young_modulus()({.T = 500}), E);
}

TEST(Orthotropy, RefusesConstantsOfNoMaterial) {
  Orthotropy wrong = alloy;
  wrong.poisson_ratios[0] = 1.3;  // above sqrt(200/150)
  EXPECT_THROW(wrong.stiffness(0), ModelError);
  wrong = alloy;
  wrong.shear_moduli[1] = Function::expression("50e3 - 100*T", {"T"});
  EXPECT_NO_THROW(wrong.stiffness(20));
  EXPECT_THROW(wrong.stiffness(600), ModelError);
}

TEST(Hill, RatiosOfOneChangeNothing) {
  EXPECT_LT((hill_transformation({}) * some - some).norm(), 1e-13 * some.norm());
}

TEST(Hill, TransformedStressHasHillsEquivalentStress) {
  const HillRatios ratios{{1.0, 0.8, 1.2, 0.9, 0.7, 1.1}};
  const auto& R = ratios.values;
  const double F = (1 / (R[1] * R[1]) + 1 / (R[2] * R[2]) - 1 / (R[0] * R[0])) / 2,
               G = (1 / (R[2] * R[2]) + 1 / (R[0] * R[0]) - 1 / (R[1] * R[1])) / 2,
               H = (1 / (R[0] * R[0]) + 1 / (R[1] * R[1]) - 1 / (R[2] * R[2])) / 2;
  const Matrix3 s = tensor::to_matrix(some);
  const auto square = [](double x) { return x * x; };
  const double q2 = F * square(s(1, 1) - s(2, 2)) + G * square(s(2, 2) - s(0, 0)) + H * square(s(0, 0) - s(1, 1)) +
                    3 * square(s(0, 1) / R[3]) + 3 * square(s(1, 2) / R[4]) + 3 * square(s(0, 2) / R[5]);
  const Matrix6 A = hill_transformation(ratios);
  EXPECT_NEAR(tensor::von_mises(A * some), std::sqrt(q2), 1e-11);
  EXPECT_LT((A * tensor::identity() - tensor::identity()).norm(), 1e-7);  // a root of rounding
  EXPECT_LT((A - A.transpose()).norm(), 1e-14);
}

TEST(ThermalExpansion, OneOrThreeCoefficients) {
  const ThermalExpansion one = Function::expression("1e-5 + 1e-8*T", {"T"});
  EXPECT_FALSE(one.has_axes);
  EXPECT_LT((one.strains(100, 20) - Vector3::Constant(1.1e-5 * 80)).norm(), 1e-18);
  const ThermalExpansion three({1e-5, 0.0, Function::expression("1e-8*T", {"T"})});
  EXPECT_TRUE(three.has_axes);
  EXPECT_FALSE(three.is_zero());
  EXPECT_LT((three.strains(100, 20) - 80 * Vector3(1e-5, 0, 1e-6)).norm(), 1e-18);
  EXPECT_TRUE(ThermalExpansion().is_zero());
}

TEST(Hill, RefusesRatiosOfNoTriangle) {
  EXPECT_THROW(hill_transformation({{1.0, 1.0, 0.4, 1, 1, 1}}), ModelError);
  EXPECT_NO_THROW(hill_transformation({{1.0, 1.0, 0.5, 1, 1, 1}}));
}

TEST(MaterialRotation, TurnsTensorsAsMatrices) {
  const Matrix3 axes = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.4).normalized().toRotationMatrix();
  const Tensor6 expected = tensor::from_matrix(axes * tensor::to_matrix(some) * axes.transpose());
  EXPECT_LT((rotation(axes) * some - expected).norm(), 1e-13 * some.norm());
  EXPECT_LT((rotation(axes) * rotation(axes).transpose() - Matrix6::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace anisotropy_tests
}  // namespace creepcontact::material
