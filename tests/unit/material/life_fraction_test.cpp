#include "creepcontact/material/life_fraction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "creepcontact/material/registry.hpp"
#include "support/says.hpp"

namespace creepcontact::material {
namespace {

Tensor6 diagonal(double x, double y, double z) {
  return (Tensor6() << x, y, z, 0, 0, 0).finished();
}

double rate(const LifeFraction& law, const Tensor6& stress, double T = 500) {
  Tensor6 strain = Tensor6::Zero();
  double own = 7;
  law.rate({.stress = tensor::view(stress), .temperature = T}, {tensor::writable(strain), {&own, 1}});
  EXPECT_EQ(strain.norm(), 0.0);
  return own;
}

std::shared_ptr<const RuptureData> power_law() {
  return rupture_expression(Function::expression("2e10*q^-4*exp(-T/1000)", {"q", "T"}));
}

LarsonMiller steel() {
  LarsonMiller data;
  data.stress = {10, 100, 200};
  data.parameter = {25000, 20000, 18000};
  return data;
}

TEST(LifeFraction, IsTheInverseOfTheRuptureTime) {
  const LifeFraction law(power_law(), 0.0);
  EXPECT_NEAR(rate(law, diagonal(100, 0, 0)), std::exp(0.5) / 200, 1e-16);
  EXPECT_NEAR(rate(law, diagonal(0, -100, 0)), std::exp(0.5) / 200, 1e-16);
  EXPECT_EQ(rate(law, diagonal(0, 0, 0)), 0.0);
  EXPECT_EQ(rate(law, diagonal(50, 50, 50)), 0.0);
}

TEST(LifeFraction, PrincipalStressCountsInTensionAlone) {
  const LifeFraction principal(power_law(), 1.0), mixed(power_law(), 0.25);
  EXPECT_NEAR(rate(principal, diagonal(100, -100, 0)), std::exp(0.5) / 200, 1e-15);
  EXPECT_EQ(rate(principal, diagonal(-100, -10, 0)), 0.0);
  const double S = 0.25 * 100 + 0.75 * std::sqrt(3.0) * 100;
  EXPECT_NEAR(rate(mixed, diagonal(100, -100, 0)), std::exp(0.5) * std::pow(S, 4) / 2e10, 1e-13);
}

TEST(LifeFraction, LarsonMillerAtAndBetweenThePoints) {
  // P = 20000 = (500 + 273.15) (20 + log10 t_r)
  const LifeFraction law(larson_miller(steel()), 0.0);
  const auto expected = [](double P) { return std::pow(10.0, 20 - P / 773.15); };
  EXPECT_NEAR(rate(law, diagonal(100, 0, 0)), expected(20000), 1e-12 * expected(20000));
  EXPECT_NEAR(rate(law, diagonal(std::sqrt(1000.0), 0, 0)), expected(22500), 1e-11 * expected(22500));
  // beyond the ends along the outermost pieces
  EXPECT_NEAR(rate(law, diagonal(1, 0, 0)), expected(30000), 1e-11 * expected(30000));
  EXPECT_NEAR(rate(law, diagonal(400, 0, 0)), expected(16000), 1e-11 * expected(16000));
  EXPECT_EQ(rate(law, diagonal(1e-300, 0, 0)), 0.0);
}

TEST(LifeFraction, LarsonMillerInOtherUnits) {
  LarsonMiller data = steel();
  data.time_unit = 1.0 / 3600;  // t in seconds, data in hours
  data.absolute_zero = 0.0;     // kelvin
  const LifeFraction law(larson_miller(data), 0.0);
  const double hours = std::pow(10.0, 20000 / 800.0 - 20);
  EXPECT_NEAR(rate(law, diagonal(100, 0, 0), 800.0), 1 / (hours * 3600), 1e-12 / (hours * 3600));
  EXPECT_TRUE(std::isnan(rate(law, diagonal(100, 0, 0), 0.0)));
}

TEST(LifeFraction, DerivativeIsTheLimitOfCentralDifferences) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-150, 150);
  for (const auto& data : {power_law(), larson_miller(steel())})
    for (const double alpha : {0.0, 0.4, 1.0}) {
      const LifeFraction law(data, alpha);
      for (int i = 0; i < 20; ++i) {
        const Tensor6 stress = Tensor6::NullaryExpr([&] { return uniform(generator); });
        const Tensor6 change = Tensor6::NullaryExpr([&] { return uniform(generator); });
        Tensor6 strain = Tensor6::Zero();
        const double h = 1e-5;
        double exact = 0;
        law.derivative({.stress = tensor::view(stress), .temperature = 500}, {.stress = tensor::view(change)},
                       {tensor::writable(strain), {&exact, 1}});
        const double difference = (rate(law, stress + h * change) - rate(law, stress - h * change)) / (2 * h);
        EXPECT_NEAR(exact, difference, 1e-6 * std::abs(exact) + 1e-9 * rate(law, stress));
      }
    }
}

TEST(LifeFraction, TellsTheLifeAlone) {
  const LifeFraction law(power_law(), 0.0);
  const double own = 0.3;
  double value = 0;
  EXPECT_TRUE(law.evaluate(life_fraction, {.internal = {&own, 1}}, {&value, 1}));
  EXPECT_EQ(value, 0.3);
  EXPECT_FALSE(law.evaluate(damage, {.internal = {&own, 1}}, {&value, 1}));
}

std::string message(const LarsonMiller& data) {
  try {
    larson_miller(data);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "";
}

TEST(LifeFraction, DataThatMakeNoSenseAreNamed) {
  LarsonMiller data = steel();
  data.parameter.pop_back();
  EXPECT_TRUE(creepcontact::test::says(message(data), {"parameter: ", "2 values", "'stress'", "3"}));
  data = steel();
  data.parameter[2] = 21000;
  EXPECT_TRUE(creepcontact::test::says(message(data), {"parameter: ", "21000 after 20000", "decrease"}));
  data = steel();
  data.stress[1] = 5;
  EXPECT_TRUE(creepcontact::test::says(message(data), {"stress: ", "5 after 10", "increase"}));
  data = steel();
  data.stress[0] = 0;
  EXPECT_TRUE(creepcontact::test::says(message(data), {"stress: ", "0", "> 0"}));
  EXPECT_TRUE(creepcontact::test::says(message({}), {"stress: ", "0 values", "two"}));
  EXPECT_EQ(message(steel()), "");
}

}  // namespace
}  // namespace creepcontact::material
