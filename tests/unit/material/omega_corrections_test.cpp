// Corrections of API 579-1 to the law omega: multiaxial stress, scatter, ductility.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace omega_corrections {
namespace {

Function function_of(const std::string& text) {
  return Function::expression(text, {"q", "T"});
}

/// rate0 = 1e-20 q^8, omega = 40.
ParameterValues corrected(double alpha, double delta_sr = 0, double delta_cd = 0) {
  return {{function_of("1e-20*q^8")}, {40.0}, {1.0}, {1.0}, {alpha}, {0.33}, {delta_sr}, {delta_cd}};
}

Tensor6 principal(double a, double b, double c) {
  Tensor6 stress = Tensor6::Zero();
  stress.head<3>() << a, b, c;
  return stress;
}

/// One point at a constant stress.
class Point {
 public:
  Point(const ParameterValues& values, const Tensor6& stress) : law_(make_law("omega", values)), stress_(stress) {}
  double rate(double eps) const {
    Tensor6 strain_rate = Tensor6::Zero();
    double own = 0;
    law_->rate(at(eps), {tensor::writable(strain_rate), {&own, 1}});
    return own;
  }
  double value(const StateVariable& variable, double eps) const {
    double result = 0;
    law_->evaluate(variable, at(eps), {&result, 1});
    return result;
  }

 private:
  PointState at(const double& eps) const {
    static constexpr double one = 1;
    return {.stress = tensor::view(stress_), .internal = {&eps, 1}, .parameters = {&one, 1}, .temperature = 500};
  }
  std::unique_ptr<CreepLaw> law_;
  Tensor6 stress_;
};

/// omega_m: the growth of log(rate) with the strain.
double effective_omega(const ParameterValues& values, const Tensor6& stress) {
  const Point point(values, stress);
  return std::log(point.rate(0.01) / point.rate(0)) / 0.01;
}

/// n = 8, so max(omega - n, 3) = 32; delta = 0.33 (trace/q - 1).
TEST(OmegaCorrections, MultiaxialCorrectionOfApi579) {
  const Tensor6 bar = principal(100, 0, 0), sphere = principal(100, 100, 0), shear = principal(100, 0, -100),
                crushed = principal(-100, 0, 0), tube = principal(100, 50, 0);
  EXPECT_NEAR(effective_omega(corrected(1), bar), 40, 1e-8);
  EXPECT_NEAR(effective_omega(corrected(2), bar), 32 + 2 * 8, 1e-8);
  EXPECT_NEAR(effective_omega(corrected(3), sphere), std::pow(32, 1 + 0.33) + 3 * 8, 1e-7);
  EXPECT_NEAR(effective_omega(corrected(2), tube), std::pow(32, 1 + 0.33 * (std::sqrt(3.0) - 1)) + 2 * 8, 1e-7);
  EXPECT_NEAR(effective_omega(corrected(1), shear), std::pow(32, 1 - 0.33) + 8, 1e-8);
  EXPECT_NEAR(effective_omega(corrected(1), crushed), std::pow(32, 1 - 0.66) + 8, 1e-8);
  EXPECT_NEAR(effective_omega(corrected(1, 0, 0.3), bar), 40 * std::pow(10, 0.3), 1e-8);
  ParameterValues brittle = corrected(1);
  brittle[1] = {10.0};  // max(10 - 8, 3) = 3
  EXPECT_NEAR(effective_omega(brittle, bar), 3 + 8, 1e-8);
}

/// The exponent n of polynomials in log q is that of their derivative.
TEST(OmegaCorrections, ExponentOfAPolynomial) {
  ParameterValues values = corrected(2);
  values[0] = {function_of("10^(-20 + 5*log10(q/6.895) + 2*log10(q/6.895)^2 - log10(q/6.895)^3)")};
  const double S = std::log10(100 / 6.895), n = 5 + 4 * S - 3 * S * S;
  EXPECT_NEAR(effective_omega(values, principal(100, 0, 0)), 40 - n + 2 * n, 1e-7);
}

TEST(OmegaCorrections, ScatterChangesTheRate) {
  const Point fast(corrected(1, -0.5), principal(100, 0, 0)), mean(corrected(1), principal(100, 0, 0));
  EXPECT_NEAR(fast.rate(0), std::sqrt(10) * mean.rate(0), 1e-12 * fast.rate(0));
}

/// Damage is t/t_r at constant stress, with t_r = 1/(omega_m rate0).
TEST(OmegaCorrections, DamageAndRemainingLife) {
  const double omega = 32 + 2 * 8, rate0 = 1e-20 * std::pow(100, 8), eps = 0.03;
  const Point bar(corrected(2), principal(100, 0, 0));
  EXPECT_NEAR(bar.value(damage, eps), 1 - std::exp(-omega * eps), 1e-10);
  EXPECT_NEAR(bar.value(remaining_life, eps), omega * rate0 * std::exp(omega * eps), 1e-9);
}

TEST(OmegaCorrections, TheMultiaxialCorrectionNeedsASmallestStress) {
  ParameterValues values = corrected(1);
  values[2] = {0.0};
  try {
    make_law("omega", values);
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key(), "min_stress");
  }
}

}  // namespace
}  // namespace omega_corrections
}  // namespace creepcontact::material
