#include "stress_function.hpp"

#include <limits>

namespace creepcontact::material {

double StressFunction::given(double q, double temperature) const {
  const double value = function_({.T = temperature, .q = q});
  return value >= 0.0 ? value : std::numeric_limits<double>::quiet_NaN();
}

double StressFunction::extended(double q, double temperature, double* slope) const {
  if (q < min_stress_) {
    const double value = given(min_stress_, temperature);
    const double secant = below_ == BelowRange::proportional ? value / min_stress_ : 0.0;
    if (slope != nullptr) *slope = secant;
    return below_ == BelowRange::proportional ? secant * q : value;
  }
  if (slope != nullptr && !function_.is_constant()) {
    constexpr double step = 3e-6;  // relative; errors of the central difference and of rounding are 1e-10
    *slope = (given(q * (1 + step), temperature) - given(q * (1 - step), temperature)) / (2 * step * q);
  }
  return given(q, temperature);
}

ParameterInfo min_stress_key(const std::string& below) {
  return {.key = "min_stress",
          .description = "smallest von Mises stress for which the functions hold; below it " + below + " [stress]",
          .strict = false,
          .fallback = {{0.0}},
          .variables = {}};
}

}  // namespace creepcontact::material
