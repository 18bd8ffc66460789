#pragma once
/// Powers with the exponents that creep laws have: mostly small whole numbers.

#include <cmath>

namespace creepcontact::material {

/// base^exponent for base >= 0. Whole exponents from 0 to 64 are multiplied out (several times faster than std::pow);
/// a result too large is infinity.
inline double power(double base, double exponent) {
  if (!(exponent >= 0.0 && exponent <= 64.0) || exponent != std::floor(exponent)) return std::pow(base, exponent);
  double result = 1.0;
  for (auto bits = static_cast<unsigned>(exponent); bits != 0; bits >>= 1U) {
    if (bits & 1U) result *= base;
    base *= base;
  }
  return result;
}

}  // namespace creepcontact::material
