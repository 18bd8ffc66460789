#include "creepcontact/material/life_fraction.hpp"

#include <algorithm>

#include "stress_measure.hpp"

namespace creepcontact::material {
namespace {

constexpr double min_remaining_life = 1e-14;  // smallest rest of life that counts

}  // namespace

void LifeFraction::rate(const PointState& at, PointRate into) const {
  const double S = StressMeasure(at.stress, alpha_).value;
  into.internal[0] = S > 0.0 ? data_->rate(S, at.temperature).value : 0.0;
}

void LifeFraction::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const StressMeasure S(at.stress, alpha_);
  const double dS = S.gradient.dot(change.stress);
  into.internal[0] = S.value > 0.0 ? data_->rate(S.value, at.temperature).slope * dS : 0.0;
}

bool LifeFraction::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable == &material::life_fraction) {
    into[0] = at.internal[0];
  } else if (&variable == &material::remaining_life) {
    const double S = StressMeasure(at.stress, alpha_).value, rest = std::max(1.0 - at.internal[0], min_remaining_life);
    into[0] = S > 0.0 ? data_->rate(S, at.temperature).value / rest : 0.0;
  } else {
    return false;
  }
  return true;
}

}  // namespace creepcontact::material
