// Numbers of creep with damage.
#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/material/kachanov_rabotnov.hpp"

namespace creepcontact::material {
namespace damage_tests {
namespace {

const std::vector<double> parameters{1e-13, 5.0, 1e-12, 4.0, 6.0, 0.0};

KachanovRabotnov law(const std::vector<double>& p) {
  return KachanovRabotnov(single_values(p));
}

struct Rate {
  Tensor6 strain = Tensor6::Zero();
  double own = 0;
};

Rate rate(const std::vector<double>& p, const Tensor6& stress, double D) {
  Rate result;
  law(p).rate({.stress = tensor::view(stress), .internal = {&D, 1}, .parameters = p},
              {tensor::writable(result.strain), {&result.own, 1}});
  return result;
}

double damage(const std::vector<double>& p, double D) {
  double value = 0;
  EXPECT_TRUE(law(p).evaluate(material::damage, {.internal = {&D, 1}, .parameters = p}, {&value, 1}));
  return value;
}

Tensor6 diagonal(double x, double y, double z) {
  return (Tensor6() << x, y, z, 0, 0, 0).finished();
}

TEST(KachanovRabotnov, RupturesAtTheTimeOfTheClosedForm) {
  // t_r = 1/((phi + 1) B sigma^r) = 1/(7e-12 1e8): D grows evenly up to 1 there.
  for (const double D : {0.0, 0.3, 0.999}) EXPECT_NEAR(rate(parameters, diagonal(100, 0, 0), D).own, 7e-4, 1e-17);
  EXPECT_NEAR(damage(parameters, 1.0), 1.0, 0.011);  // 1 - D counts as 1e-14
  EXPECT_EQ(damage(parameters, 0.0), 0.0);
}

TEST(KachanovRabotnov, DamageRaisesTheStress) {
  // D = 1 - (1 - w)^7 with w = 0.2
  const double D = 1 - std::pow(0.8, 7);
  EXPECT_NEAR(damage(parameters, D), 0.2, 1e-14);
  const double expected = 1e-13 * std::pow(100 / 0.8, 5);
  EXPECT_NEAR(rate(parameters, diagonal(100, 0, 0), D).strain[0], expected, 1e-13 * expected);
}

TEST(KachanovRabotnov, DamageObeysItsOwnEquation) {
  // dw/dt = B S^r/(1-w)^phi by the chain rule: dD/dt = (phi+1) (1-w)^phi dw/dt
  const double w = 0.35, D = 1 - std::pow(1 - w, 7);
  const double dw = rate(parameters, diagonal(0, 80, 0), D).own / (7 * std::pow(1 - w, 6));
  const double expected = 1e-12 * std::pow(80, 4) / std::pow(1 - w, 6);
  EXPECT_NEAR(dw, expected, 1e-12 * expected);
}

TEST(KachanovRabotnov, AnExponentThatDependsOnTheTemperatureMakesDamageItselfTheVariable) {
  ParameterValues values = single_values(parameters);
  values[KachanovRabotnov::phi] = {Function::expression("6 + 0*T", {"T"})};
  const KachanovRabotnov by_temperature(values);
  const Tensor6 stress = diagonal(100, 0, 0);
  const double w = 0.2;
  const PointState at{.stress = tensor::view(stress), .internal = {&w, 1}, .parameters = parameters};
  Tensor6 strain = Tensor6::Zero();
  double own = 0;
  by_temperature.rate(at, {tensor::writable(strain), {&own, 1}});
  EXPECT_NEAR(own, 1e-12 * 1e8 / std::pow(0.8, 6), 1e-16);
  EXPECT_NEAR(strain[0], 1e-13 * std::pow(100 / 0.8, 5), 1e-15);
  double value = 0;
  EXPECT_TRUE(by_temperature.evaluate(material::damage, at, {&value, 1}));
  EXPECT_NEAR(value, 0.2, 1e-15);
}

TEST(KachanovRabotnov, StressThatDamages) {
  std::vector<double> p = parameters;
  p[5] = 1.0;
  // Compression does no damage, tension across shear does: diag(100, -100, 0) has sigma_1 = 100, q = sqrt(3) 100.
  EXPECT_EQ(rate(p, diagonal(-100, 0, 0), 0).own, 0.0);
  EXPECT_NEAR(rate(p, diagonal(100, -100, 0), 0).own, 7e-4, 1e-16);
  p[5] = 0.25;
  const double S = 0.25 * 100 + 0.75 * std::sqrt(3.0) * 100;
  EXPECT_NEAR(rate(p, diagonal(100, -100, 0), 0).own, 7e-12 * std::pow(S, 4), 1e-15);
}

TEST(KachanovRabotnov, StaysFiniteBeyondRupture) {
  for (const double D : {1.0, 1.5}) {
    const Rate beyond = rate(parameters, diagonal(100, 0, 0), D);
    EXPECT_TRUE(beyond.strain.allFinite() && std::isfinite(beyond.own)) << D;
    EXPECT_GT(beyond.strain[0], rate(parameters, diagonal(100, 0, 0), 0.999).strain[0]);
  }
  EXPECT_LT(damage(parameters, -1e-3), 0.0);  // a stage of an integrator
  EXPECT_FALSE(law(parameters).evaluate(life_fraction, {}, {}));
}

}  // namespace
}  // namespace damage_tests
}  // namespace creepcontact::material
