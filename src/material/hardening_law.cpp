#include "hardening_law.hpp"

#include <algorithm>

#include "coaxial.hpp"

namespace creepcontact::material {

double HardeningLaw::strain(const PointState& at) const {
  return accumulates_ ? std::max(at.internal[0], at.min_strain) : at.min_strain;
}

void HardeningLaw::rate(const PointState& at, PointRate into) const {
  const Deviator now = deviator(at.stress);
  const double f = now.q > 0.0 ? equivalent_rate(now.q, strain(at), at) : 0.0;
  if (now.q > 0.0) add_flow(now, f, into.creep_strain);
  if (accumulates_) into.internal[0] = f;
}

void HardeningLaw::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const Deviator now = deviator(at.stress);
  const Tensor6 ds = tensor::deviator(change.stress);
  const HardeningRate f = linearized_rate(now.q == 0.0 ? vanishing_stress : now.q, strain(at), at);
  add_tangent(now, coaxial_tangent(now.q, f.value, f.by_stress), ds, into.creep_strain);
  if (!accumulates_) return;
  into.internal[0] = 0.0;
  if (now.q == 0.0) return;
  const double by_strain = at.internal[0] > at.min_strain ? f.by_strain * change.internal[0] : 0.0;
  add_flow(now, by_strain, into.creep_strain);
  into.internal[0] = f.by_stress * 1.5 * now.s.dot(ds) / now.q + by_strain;
}

StressTangent HardeningLaw::stress_tangent(const PointState& at) const {
  const double q = deviator(at.stress).q;
  const HardeningRate f = linearized_rate(q == 0.0 ? vanishing_stress : q, strain(at), at);
  return coaxial_tangent(q, f.value, f.by_stress);
}

void HardeningLaw::increment(const PointState& at, double duration, PointIncrement into) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const double change = accumulated(now.q, accumulates_ ? std::max(at.internal[0], 0.0) : 0.0, at, duration);
  add_flow(now, change, into.creep_strain);
  if (accumulates_) into.internal[0] += change;
}

bool HardeningLaw::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &hardening_strain || !accumulates_) return false;
  into[0] = at.internal[0];
  return true;
}

}  // namespace creepcontact::material
