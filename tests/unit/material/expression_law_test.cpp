// Numbers of the law that the user writes.
#include "../../../src/material/expression_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/material/norton.hpp"
#include "../../../src/material/strain_hardening.hpp"
#include "../../../src/material/time_hardening.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace expression_law_tests {
namespace {

const Tensor6 uniaxial = (Tensor6() << 200, 0, 0, 0, 0, 0).finished();

ExpressionLaw law(const std::string& rate) {
  return ExpressionLaw(ParameterValues{{Function::expression(rate, {"q", "T", "t", "eps"})}});
}

struct Result {
  Tensor6 strain = Tensor6::Zero();
  double own = 0;
};

Result rate(const CreepLaw& law, PointState at) {
  Result result;
  law.rate(at, {tensor::writable(result.strain), {&result.own, 1}});
  return result;
}

Result increment(const CreepLaw& law, PointState at, double duration) {
  Result result;
  law.increment(at, duration, {tensor::writable(result.strain), {&result.own, 1}});
  return result;
}

TEST(ExpressionLaw, KnowsStressTemperatureTimeAndStrain) {
  const double eps = 0.5;
  const PointState at{.stress = tensor::view(uniaxial), .internal = {&eps, 1}, .time = 3.0, .temperature = 7.0};
  EXPECT_EQ(rate(law("q + 1000*T + 10000*t + eps"), at).strain[0], 37200.5);
  EXPECT_EQ(rate(law("q + 1000*T + 10000*t + eps"), at).own, 37200.5);
}

TEST(ExpressionLaw, HasAnInternalVariableOnlyIfItOccurs) {
  EXPECT_EQ(law("1e-13*q^5").n_internal(), 0);
  EXPECT_EQ(law("1e-13*q^5*(1 + eps)").n_internal(), 1);
}

TEST(ExpressionLaw, NortonWrittenOutIsNorton) {
  const std::vector<double> parameters{3.125e-14, 5.0};
  const Tensor6 stress = (Tensor6() << 120, -30, 14, 50, -20, 5).finished();
  const PointState at{.stress = tensor::view(stress), .parameters = parameters};
  const Norton norton(single_values(parameters));
  const Result expected = rate(norton, at);
  EXPECT_LT((rate(law("3.125e-14*q^5"), at).strain - expected.strain).norm(), 1e-14 * expected.strain.norm());
  const StressTangent a = law("3.125e-14*q^5").stress_tangent(at), b = norton.stress_tangent(at);
  // Of the two evaluations that the difference in q takes anyway: their mean.
  EXPECT_NEAR(a.deviatoric, b.deviatoric, 1e-9 * b.deviatoric);
  EXPECT_NEAR(a.radial, b.radial, 1e-8 * b.radial);
}

TEST(ExpressionLaw, ARateBelowZeroOrUndefinedIsNoNumber) {
  const PointState at{.stress = tensor::view(uniaxial)};
  EXPECT_TRUE(std::isnan(rate(law("100 - q"), at).strain[0]));
  EXPECT_TRUE(std::isnan(rate(law("sqrt(100 - q)"), at).strain[0]));
  EXPECT_FALSE(std::isfinite(rate(law("1/(q - 200)"), at).strain[0]));
}

TEST(ExpressionLaw, AStartSingularInTimeIsTimeHardening) {
  const std::vector<double> parameters{3.125e-14, 5.0, 0.5};
  const TimeHardening built_in("time_hardening", single_values(parameters));
  const PointState at{.stress = tensor::view(uniaxial), .parameters = parameters};
  const ExpressionLaw written = law("0.5*3.125e-14*q^5*t^-0.5");
  EXPECT_NEAR(written.start_exponent(at), 0.5, 1e-12);
  PointState later = at;
  later.time = 1.0;
  EXPECT_EQ(written.start_exponent(later), 1.0);
  for (const double d : {1e-12, 1e-3, 10.0}) {
    const Result expected = increment(built_in, at, d);
    EXPECT_LT((increment(written, at, d).strain - expected.strain).norm(), 1e-12 * expected.strain.norm()) << d;
  }
}

TEST(ExpressionLaw, WhatIsAddedToASingularTermIsNotLost) {
  // 2 sqrt(t) + 3 t
  const PointState at{.stress = tensor::view(uniaxial)};
  const ExpressionLaw sum = law("1e-4*(t^-0.5 + 3)");
  EXPECT_NEAR(sum.start_exponent(at), 0.5, 1e-12);
  const double expected = 1e-4 * (2 * std::sqrt(0.04) + 3 * 0.04);
  EXPECT_NEAR(increment(sum, at, 0.04).strain[0], expected, 1e-13 * expected);
}

TEST(ExpressionLaw, AStartSingularInStrainIsStrainHardening) {
  const std::vector<double> parameters{3.125e-14, 5.0, 1.0 / 3};
  const StrainHardening built_in("strain_hardening", single_values(parameters));
  const double virgin = 0;
  const PointState at{
      .stress = tensor::view(uniaxial), .internal = {&virgin, 1}, .parameters = parameters, .time = 8.0};
  const ExpressionLaw written = law("(3.125e-14*q^5)^3/3*eps^-2");
  EXPECT_NEAR(written.start_exponent(at), 1.0 / 3, 1e-12);
  for (const double d : {1e-9, 1e-3, 1.0}) {
    const Result expected = increment(built_in, at, d);
    EXPECT_NEAR(increment(written, at, d).own, expected.own, 1e-12 * expected.own) << d;
    EXPECT_NEAR(increment(written, at, d).strain[0], expected.strain[0], 1e-12 * expected.own) << d;
  }
}

TEST(ExpressionLaw, SingularInBoth) {
  // eps' = c t^-0.5 eps^-1: eps^2/2 = 2 c sqrt(t)
  const double virgin = 0;
  const PointState at{.stress = tensor::view(uniaxial), .internal = {&virgin, 1}};
  const ExpressionLaw both = law("1e-6*t^-0.5/eps");
  EXPECT_NEAR(both.start_exponent(at), 0.25, 1e-12);
  const double expected = std::sqrt(4e-6 * std::sqrt(0.01));
  EXPECT_NEAR(increment(both, at, 0.01).own, expected, 1e-12 * expected);
}

TEST(ExpressionLaw, RegularRatesStartRegularly) {
  const double virgin = 0;
  const PointState at{.stress = tensor::view(uniaxial), .internal = {&virgin, 1}};
  for (const char* text : {"1e-13*q^5", "1e-5*exp(-t)", "1e-5*sqrt(t)", "1e-5*(t + 1e-3)^-0.5", "1e-5/(1e-3 + eps)"})
    EXPECT_EQ(law(text).start_exponent(at), 1.0) << text;
}

TEST(ExpressionLaw, AnyNumberOfThreads) {
  const ExpressionLaw written = law("1e-13*q^5*(1 + t)");
  const std::vector<double> q{10, 50, 100, 250};
  std::vector<double> found(4000);
#pragma omp parallel for num_threads(4)
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = written.equivalent_rate(q[i % 4], 0, {.time = double(i)});
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], 1e-13 * std::pow(q[i % 4], 5) * double(1 + i), 1e-12 * found[i]) << i;
}

}  // namespace
}  // namespace expression_law_tests
}  // namespace creepcontact::material
