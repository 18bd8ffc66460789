#include "stress_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace creepcontact::material {

double StressFunction::given(double q, double temperature, double strength) const {
  const double value = function_({.T = temperature, .q = q, .U = strength});
  return value >= 0.0 ? value : std::numeric_limits<double>::quiet_NaN();
}

double StressFunction::extended(double q, double temperature, double strength, double* slope) const {
  if (q < min_stress_) {
    const double value = given(min_stress_, temperature, strength);
    const double secant = below_ == BelowRange::proportional ? value / min_stress_ : 0.0;
    if (slope != nullptr) *slope = secant;
    return below_ == BelowRange::proportional ? secant * q : value;
  }
  if (slope != nullptr && !function_.is_constant()) {
    constexpr double step = 3e-6;  // relative; errors of the central difference and of rounding are 1e-10
    *slope =
        (given(q * (1 + step), temperature, strength) - given(q * (1 - step), temperature, strength)) / (2 * step * q);
  }
  return given(q, temperature, strength);
}

std::pair<double, double> StressFunction::exponent_and_slope(double q, double temperature) const {
  if (function_.is_constant()) return {0.0, 0.0};
  constexpr double step = 0.01;  // of log q
  const double at = std::max(q, min_stress_);
  std::array<double, 5> logs;
  for (int i = 0; i < 5; ++i) logs[i] = std::log(given(at * std::exp((i - 2) * step), temperature, 1.0));
  const double exponent = (logs[0] - 8 * logs[1] + 8 * logs[3] - logs[4]) / (12 * step);
  const double curvature = (-logs[0] + 16 * logs[1] - 30 * logs[2] + 16 * logs[3] - logs[4]) / (12 * step * step);
  return {exponent, q < min_stress_ ? 0.0 : curvature / q};
}

ParameterInfo min_stress_key(const std::string& below) {
  return {.key = "min_stress",
          .description = "smallest von Mises stress for which the functions hold; below it " + below + " [stress]",
          .dimension = unit::stress,
          .strict = false,
          .fallback = {{0.0}},
          .variables = {}};
}

}  // namespace creepcontact::material
