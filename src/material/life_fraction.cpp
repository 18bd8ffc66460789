#include "creepcontact/material/life_fraction.hpp"

#include "stress_measure.hpp"

namespace creepcontact::material {

void LifeFraction::rate(const Point& at, double* /*strain_rate*/, double* internal_rate) const {
  const double S = StressMeasure(Eigen::Map<const Tensor6>(at.stress), alpha_).value;
  internal_rate[0] = S > 0.0 ? data_->rate(S, at.temperature).value : 0.0;
}

void LifeFraction::derivative(const Point& at, const double* d_stress, const double* /*d_state*/,
                              const double* /*d_internal*/, double* /*d_strain_rate*/, double* d_internal_rate) const {
  const StressMeasure S(Eigen::Map<const Tensor6>(at.stress), alpha_);
  const double dS = S.gradient.dot(Eigen::Map<const Tensor6>(d_stress));
  d_internal_rate[0] = S.value > 0.0 ? data_->rate(S.value, at.temperature).slope * dS : 0.0;
}

std::optional<double> LifeFraction::measure(Measure of, const Point& at) const {
  if (of != Measure::life_fraction) return std::nullopt;
  return at.internal[0];
}

}  // namespace creepcontact::material
