#pragma once
/// Parameters that the user writes as functions of the equivalent stress q, of the temperature T, and of a strength U
/// that some laws have.

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>
#include <utility>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// What such a function is below the smallest stress for which it was fitted: polynomials in the logarithm of the
/// stress mean nothing at small stresses.
enum class BelowRange {
  proportional,  ///< falls to 0 in proportion to q, as a rate must
  constant       ///< has the value of the smallest stress
};

/// Immutable, thread-safe. Values that are negative count as undefined: NaN.
class StressFunction {
 public:
  /// @param function  of q and T @param min_stress  >= 0; 0: the function holds at all stresses
  StressFunction(Function function, double min_stress, BelowRange below)
      : function_(std::move(function)), min_stress_(min_stress), below_(below) {}

  double min_stress() const { return min_stress_; }

  /// @param q  > 0
  double operator()(double q, double temperature, double strength = 1) const {
    return extended(q, temperature, strength, nullptr);
  }
  /// The derivative is a central difference with a relative error of about 1e-10.
  template <class Derivatives>
  Eigen::AutoDiffScalar<Derivatives> operator()(const Eigen::AutoDiffScalar<Derivatives>& q, double temperature,
                                                double strength = 1) const {
    double slope = 0;
    const double value = extended(q.value(), temperature, strength, &slope);
    return {value, slope * q.derivatives()};
  }

  /// The exponent d(log value)/d(log q), by differences that are exact where the logarithm of the value is a polynomial
  /// of up to the fourth degree in log q; below the smallest stress that of the smallest stress. @param q  > 0
  double exponent(double q, double temperature) const { return exponent_and_slope(q, temperature).first; }
  template <class Derivatives>
  Eigen::AutoDiffScalar<Derivatives> exponent(const Eigen::AutoDiffScalar<Derivatives>& q, double temperature) const {
    const auto [value, slope] = exponent_and_slope(q.value(), temperature);
    return {value, slope * q.derivatives()};
  }

 private:
  std::pair<double, double> exponent_and_slope(double q, double temperature) const;
  /// @param slope  nullptr: not wanted
  double extended(double q, double temperature, double strength, double* slope) const;
  double given(double q, double temperature, double strength) const;

  Function function_;
  double min_stress_;
  BelowRange below_;
};

/// The optional key min_stress. @param below  what holds at smaller stresses
ParameterInfo min_stress_key(const std::string& below);

}  // namespace creepcontact::material
