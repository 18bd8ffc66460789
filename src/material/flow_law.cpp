#include "flow_law.hpp"

#include "coaxial.hpp"

namespace creepcontact::material {
namespace {

EquivalentRate at_any_stress(const FlowLaw& law, double q, const PointState& at) {
  return law.equivalent_rate(q == 0.0 ? vanishing_stress : q, at);
}

StressTangent tangent(const FlowLaw& law, double q, const PointState& at) {
  const EquivalentRate f = at_any_stress(law, q, at);
  return coaxial_tangent(q, f.value, f.slope);
}

}  // namespace

void FlowLaw::rate(const PointState& at, PointRate into) const {
  const Deviator now = deviator(at.stress);
  if (now.q > 0.0) add_flow(now, equivalent_rate(now.q, at).value, into.creep_strain);
}

void FlowLaw::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const Deviator now = deviator(at.stress);
  add_tangent(now, tangent(*this, now.q, at), tensor::deviator(change.stress), into.creep_strain);
}

StressTangent FlowLaw::stress_tangent(const PointState& at) const {
  return tangent(*this, deviator(at.stress).q, at);
}

StressTangent FlowLaw::rate_and_tangent(const PointState& at, PointRate into) const {
  const Deviator now = deviator(at.stress);
  const EquivalentRate f = at_any_stress(*this, now.q, at);
  if (now.q > 0.0) add_flow(now, f.value, into.creep_strain);
  return coaxial_tangent(now.q, f.value, f.slope);
}

}  // namespace creepcontact::material
