#include "creepcontact/material/hardening_law.hpp"

#include <algorithm>

#include "coaxial.hpp"

namespace creepcontact::material {

double HardeningLaw::strain(const Point& at) const {
  return accumulates_ ? std::max(at.internal[0], at.least_strain) : at.least_strain;
}

void HardeningLaw::rate(const Point& at, double* strain_rate, double* internal_rate) const {
  const Deviator now = deviator(at.stress);
  const double f = now.q > 0.0 ? equivalent_rate(now.q, strain(at), at) : 0.0;
  if (now.q > 0.0) add_flow(now, f, strain_rate);
  if (accumulates_) internal_rate[0] = f;
}

void HardeningLaw::derivative(const Point& at, const double* d_stress, const double* /*d_state*/,
                              const double* d_internal, double* d_strain_rate, double* d_internal_rate) const {
  const Deviator now = deviator(at.stress);
  const Tensor6 ds = tensor::deviator(Eigen::Map<const Tensor6>(d_stress));
  const HardeningRate f = linearized_rate(now.q == 0.0 ? vanishing_stress : now.q, strain(at), at);
  add_tangent(now, coaxial_tangent(now.q, f.value, f.by_stress), ds, d_strain_rate);
  if (!accumulates_) return;
  d_internal_rate[0] = 0.0;
  if (now.q == 0.0) return;
  const double by_strain = at.internal[0] > at.least_strain ? f.by_strain * d_internal[0] : 0.0;
  add_flow(now, by_strain, d_strain_rate);
  d_internal_rate[0] = f.by_stress * 1.5 * now.s.dot(ds) / now.q + by_strain;
}

StressTangent HardeningLaw::stress_tangent(const Point& at) const {
  const double q = deviator(at.stress).q;
  const HardeningRate f = linearized_rate(q == 0.0 ? vanishing_stress : q, strain(at), at);
  return coaxial_tangent(q, f.value, f.by_stress);
}

void HardeningLaw::increment(const Point& at, double duration, double* strain, double* internal) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const double change = accumulated(now.q, accumulates_ ? std::max(at.internal[0], 0.0) : 0.0, at, duration);
  add_flow(now, change, strain);
  if (accumulates_) internal[0] += change;
}

}  // namespace creepcontact::material
