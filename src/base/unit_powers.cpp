#include "creepcontact/base/unit_powers.hpp"

#include <cmath>

namespace creepcontact {

double UnitChange::of(BaseUnit unit) const {
  switch (unit) {
    case BaseUnit::stress:
      return stress;
    case BaseUnit::time:
      return time;
    case BaseUnit::length:
      return length;
    case BaseUnit::degree:
    case BaseUnit::temperature:
      return degree;
  }
  return 1;
}

double factor(const UnitPowers& dimension, const UnitChange& change,
              const std::function<double(std::size_t)>& constant) {
  double product = 1;
  for (const UnitPower& power : dimension.powers()) {
    const UnitExponent& exponent = power.exponent;
    if (exponent.exclusive && constant(*exponent.exclusive) != 0) continue;
    double value = exponent.number;
    if (exponent.constant) {
      const double other = constant(*exponent.constant);
      value *= exponent.is_reciprocal ? 1 / other : other;
    }
    product *= std::pow(change.of(power.unit), value);
  }
  return product;
}

}  // namespace creepcontact
