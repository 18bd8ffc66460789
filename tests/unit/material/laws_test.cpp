// Numbers of the single laws.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../../../src/material/ageing.hpp"
#include "../../../src/material/garofalo.hpp"
#include "../../../src/material/norton.hpp"
#include "../../../src/material/power.hpp"
#include "creepcontact/base/error.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace {

PointState at(const std::vector<double>& parameters) {
  return {.parameters = parameters};
}

TEST(Power, WholeExponentsAgreeWithTheLibrary) {
  for (const double base : {0.0, 0.3, 1.0, 7.7, 250.0})
    for (const double n : {0.0, 1.0, 2.0, 5.0, 7.0, 12.0, 64.0})
      EXPECT_NEAR(power(base, n), std::pow(base, n), 1e-13 * std::pow(base, n)) << base << "^" << n;
}

TEST(Power, OtherExponentsAreTheLibrarys) {
  for (const double n : {-2.0, 0.5, 4.2, 65.0, 1e10}) EXPECT_EQ(power(1.5, n), std::pow(1.5, n));
}

TEST(Power, TooLargeIsInfinite) {
  EXPECT_EQ(power(1e200, 7.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(power(1e-200, 7.0), 0.0);
}

TEST(Norton, UniaxialTestOfNafems) {
  // NAFEMS R0027: 200 MPa give 0.01 per hour along and -0.005 across the load.
  const std::vector<double> parameters{3.125e-14, 5.0};
  const Tensor6 stress = (Tensor6() << 200, 0, 0, 0, 0, 0).finished();
  const PointState point{.stress = tensor::view(stress), .parameters = parameters};
  Tensor6 rate = Tensor6::Zero();
  Norton(single_values(parameters)).rate(point, {tensor::writable(rate)});
  const Tensor6 expected = (Tensor6() << 0.01, -0.005, -0.005, 0, 0, 0).finished();
  EXPECT_LT((rate - expected).norm(), 1e-15);
}

TEST(Norton, PureShear) {
  // q = sqrt(3) tau; the shear rate (tensor component) is 3/2 A q^(n-1) tau.
  const std::vector<double> parameters{1e-10, 3.5};
  const double tau = 40.0, q = std::sqrt(3.0) * tau;
  const Tensor6 stress = (Tensor6() << 0, 0, 0, tensor::sqrt2 * tau, 0, 0).finished();
  const PointState point{.stress = tensor::view(stress), .parameters = parameters};
  Tensor6 rate = Tensor6::Zero();
  Norton(single_values(parameters)).rate(point, {tensor::writable(rate)});
  const double expected = 1.5 * 1e-10 * std::pow(q, 2.5) * tau;
  EXPECT_NEAR(tensor::to_matrix(rate)(0, 1), expected, 1e-13 * expected);
}

TEST(Norton, LinearCreepHasItsTangentAtZeroStress) {
  const std::vector<double> parameters{1e-12, 1.0};
  const Tensor6 stress = Tensor6::Zero();
  const PointState point{.stress = tensor::view(stress), .parameters = parameters};
  const StressTangent c = Norton(single_values(parameters)).stress_tangent(point);
  EXPECT_DOUBLE_EQ(c.deviatoric, 1.5e-12);
  EXPECT_EQ(c.radial, 0.0);
}

TEST(Norton, TooLargeAStressGivesInfinity) {
  const std::vector<double> parameters{1e-14, 7.0};
  const EquivalentRate f = Norton(single_values(parameters)).equivalent_rate(1e60, at(parameters));
  EXPECT_EQ(f.value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(f.slope, std::numeric_limits<double>::infinity());
}

TEST(Garofalo, IsNortonAtLowStressAndExponentialAtHighStress) {
  const std::vector<double> parameters{1e-6, 0.02, 5.0};
  const Garofalo law(single_values(parameters));
  const double low = 1e-6 * std::pow(0.02 * 0.01, 5);
  EXPECT_NEAR(law.equivalent_rate(0.01, at(parameters)).value, low, 1e-6 * low);
  const double high = 1e-6 * std::exp(5 * 0.02 * 1000) / 32;
  EXPECT_NEAR(law.equivalent_rate(1000, at(parameters)).value, high, 1e-12 * high);
}

TEST(Ageing, IsAStrainOfTheMoment) {
  // 1e-13 100^5 4^0.5 = 2e-3, back at nothing with the stress
  const std::vector<double> parameters{1e-13, 5.0, 0.5};
  const Ageing law(single_values(parameters));
  EXPECT_TRUE(law.is_isochronous());
  EXPECT_NEAR(law.equivalent_rate(100.0, {.parameters = parameters, .time = 4.0}).value, 2e-3, 1e-17);
  EXPECT_EQ(law.equivalent_rate(100.0, {.parameters = parameters, .time = 0.0}).value, 0.0);
}

class Arrhenius : public testing::TestWithParam<std::string> {
 protected:
  /// The law with an activation energy, and its first parameter.
  static Function factor(const std::string& name, const Function& energy, ParameterValues more = {}) {
    ParameterValues values{{2.0}, {5.0}};
    if (name == "garofalo") values.push_back({4.0});
    values.push_back({energy});
    values.insert(values.end(), more.begin(), more.end());
    return make_law(name, values)->parameters()[0];
  }
};

TEST_P(Arrhenius, ScalesTheRate) {
  const Function A = factor(GetParam(), 3e5);
  EXPECT_TRUE(A.depends_on_temperature());
  const double expected = 2.0 * std::exp(-3e5 / (8.314462618 * 773.15));
  EXPECT_NEAR(A({.T = 500.0}), expected, 1e-14 * expected);
  EXPECT_EQ(A.text(), "(2)*exp(-(300000)/(8.314462618*(T - (-273.15))))");
  const double in_kelvin = factor(GetParam(), 3e5, {{8.314462618}, {0.0}})({.T = 773.15});
  EXPECT_NEAR(in_kelvin, expected, 1e-12 * expected);
}

TEST_P(Arrhenius, WithoutEnergyTheFactorStaysAsItIs) {
  EXPECT_EQ(factor(GetParam(), 0.0).text(), "2");
  EXPECT_TRUE(factor(GetParam(), 0.0).is_constant());
}

TEST_P(Arrhenius, AbsoluteZeroIsAnError) {
  const Function A = factor(GetParam(), 3e5);
  for (const double T : {-273.15, -300.0, std::nan("")}) EXPECT_THROW(A({.T = T}), ModelError) << T;
}

INSTANTIATE_TEST_SUITE_P(Laws, Arrhenius, testing::Values("norton", "garofalo"),
                         [](const auto& law) { return law.param; });

}  // namespace
}  // namespace creepcontact::material
