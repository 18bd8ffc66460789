// Numbers of the laws of primary creep.
#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/material/strain_hardening.hpp"
#include "../../../src/material/time_hardening.hpp"
#include "support/says.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace {

const Tensor6 uniaxial = (Tensor6() << 200, 0, 0, 0, 0, 0).finished();

TimeHardening time_law(const std::vector<double>& parameters) {
  return {"time_hardening", single_values(parameters)};
}

TEST(TimeHardening, PrimaryCreepOfNafems) {
  // NAFEMS R0027: eps = A q^5 sqrt(t), A = 3.125e-14: 0.01 sqrt(t) at 200 MPa, the rate half of that by sqrt(t).
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5};
  Tensor6 rate = Tensor6::Zero(), strain = Tensor6::Zero();
  const PointState at{.stress = tensor::view(uniaxial), .parameters = parameters, .time = 100.0};
  time_law(parameters).rate(at, {tensor::writable(rate)});
  EXPECT_NEAR(rate[0], 0.0005, 1e-16);
  EXPECT_NEAR(rate[1], -0.00025, 1e-16);
  time_law(parameters)
      .increment({.stress = tensor::view(uniaxial), .parameters = parameters}, 1000.0, {tensor::writable(strain)});
  EXPECT_NEAR(strain[0], 0.01 * std::sqrt(1000.0), 1e-14);
}

TEST(TimeHardening, IsSingularAtTimeZeroAlone) {
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5}, steady{1e-13, 5.0, 1.0}, none{0.0, 5.0, 0.5};
  EXPECT_EQ(time_law(parameters).start_exponent({.parameters = parameters}), 0.5);
  EXPECT_EQ(time_law(parameters).start_exponent({.parameters = parameters, .time = 1e-300}), 1.0);
  EXPECT_EQ(time_law(steady).start_exponent({.parameters = steady}), 1.0);
  EXPECT_EQ(time_law(none).start_exponent({.parameters = none}), 1.0);
  Tensor6 rate = Tensor6::Zero();
  time_law(none).rate({.stress = tensor::view(uniaxial), .parameters = none}, {tensor::writable(rate)});
  EXPECT_EQ(rate.norm(), 0.0);
}

TEST(TimeHardening, AShortStepLateLosesNoDigits) {
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5};
  Tensor6 strain = Tensor6::Zero();
  time_law(parameters)
      .increment({.stress = tensor::view(uniaxial), .parameters = parameters, .time = 1e6}, 1e-8,
                 {tensor::writable(strain)});
  const double expected = 0.01 * 0.5 / std::sqrt(1e6) * 1e-8;
  EXPECT_NEAR(strain[0], expected, 1e-12 * expected);
}

TEST(GrahamWalles, AddsItsTerms) {
  // 1e-8 q^2 t^(1/3) + 1e-13 q^5 t + 1e-15 q^5 t^3 at q = 200, t = 8.
  const std::vector<double> parameters{1e-8, 1e-13, 1e-15, 2.0, 5.0, 5.0, 1.0 / 3, 1.0, 3.0};
  const TimeHardening law("graham_walles", {{1e-8, 1e-13, 1e-15}, {2.0, 5.0, 5.0}, {1.0 / 3, 1.0, 3.0}});
  Tensor6 strain = Tensor6::Zero(), rate = Tensor6::Zero();
  law.increment({.stress = tensor::view(uniaxial), .parameters = parameters}, 8.0, {tensor::writable(strain)});
  EXPECT_NEAR(strain[0], 1e-8 * 4e4 * 2 + 1e-13 * 3.2e11 * 8 + 1e-15 * 3.2e11 * 512, 1e-13);
  law.rate({.stress = tensor::view(uniaxial), .parameters = parameters, .time = 8.0}, {tensor::writable(rate)});
  EXPECT_NEAR(rate[0], 1e-8 * 4e4 / 12 + 1e-13 * 3.2e11 + 3e-15 * 3.2e11 * 64, 1e-13);
  EXPECT_EQ(law.start_exponent({.parameters = parameters}), 1.0 / 3);
}

TEST(GrahamWalles, ListsThatDifferAreNamed) {
  try {
    TimeHardening("graham_walles", {{1e-8, 1e-13}, {2.0, 5.0}, {1.0}});
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key(), "m");
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"list of 1", "'A'", "2"}));
  }
  EXPECT_THROW(TimeHardening("graham_walles", {{}, {}, {}}), ParameterError);
}

TEST(StrainHardening, PrimaryCreepOfNafems) {
  // rate = 1/2 A^2 q^10 / eps: at 0.01 sqrt(100) = 0.1 the rate of time hardening at t = 100.
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5};
  const double eps = 0.1;
  Tensor6 rate = Tensor6::Zero();
  double own = 7;
  const StrainHardening law("strain_hardening", single_values(parameters));
  law.rate({.stress = tensor::view(uniaxial), .internal = {&eps, 1}, .parameters = parameters},
           {tensor::writable(rate), {&own, 1}});
  EXPECT_NEAR(rate[0], 0.0005, 1e-16);
  EXPECT_NEAR(own, 0.0005, 1e-16);
}

TEST(StrainHardening, VirginMaterialFollowsTheClosedForm) {
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5};
  const StrainHardening law("strain_hardening", single_values(parameters));
  double own = 0;
  const double virgin = 0;
  Tensor6 strain = Tensor6::Zero();
  const PointState at{
      .stress = tensor::view(uniaxial), .internal = {&virgin, 1}, .parameters = parameters, .time = 55.0};
  law.increment(at, 1e-6, {tensor::writable(strain), {&own, 1}});
  EXPECT_NEAR(own, 1e-5, 1e-19);
  EXPECT_NEAR(strain[0], 1e-5, 1e-19);
  EXPECT_EQ(law.start_exponent(at), 0.5);
}

TEST(StrainHardening, NegativeAndVirginStrainCountAsTheFloor) {
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5};
  const StrainHardening law("strain_hardening", single_values(parameters));
  double expected = 0;
  for (const double eps : {PointState{}.min_strain, 0.0, -1e-3}) {
    Tensor6 rate = Tensor6::Zero();
    double own = 0;
    law.rate({.stress = tensor::view(uniaxial), .internal = {&eps, 1}, .parameters = parameters},
             {tensor::writable(rate), {&own, 1}});
    EXPECT_TRUE(std::isfinite(own));
    if (expected == 0) expected = own;
    EXPECT_EQ(own, expected);
  }
}

TEST(StrainHardening, ASteepLawNeitherOverflowsNorUnderflows) {
  // n/m = 20 at q = 300; A^(1/m) alone would be 1e-600.
  const std::vector<double> parameters{1e-30, 1.0, 0.05};
  const double eps = 1e-28;
  const StrainHardening law("strain_hardening", single_values(parameters));
  const double f = law.equivalent_rate(300.0, eps, {.parameters = parameters});
  const double expected = 0.05 * 3e-28 * std::pow(3.0, 19.0);
  EXPECT_NEAR(f, expected, 1e-12 * expected);
}

TEST(StrainHardening, TheTimeExponentIsANumberInItsRange) {
  EXPECT_THROW(StrainHardening("strain_hardening", {{1e-13}, {5.0}, {1.1}}), ParameterError);
  EXPECT_THROW(StrainHardening("strain_hardening", {{1e-13}, {5.0}, {0.0}}), ParameterError);
  EXPECT_THROW(StrainHardening("strain_hardening", {{1e-13}, {5.0}, {std::nan("")}}), ParameterError);
  try {
    StrainHardening("strain_hardening", {{1e-13}, {5.0}, {Function::expression("0.3 + T/1e4", {"T"})}});
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key(), "m");
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"0.3 + T/1e4", "(0, 1]"}));
  }
}

}  // namespace
}  // namespace creepcontact::material
