#include "creepcontact/material/flow_law.hpp"

#include "coaxial.hpp"

namespace creepcontact::material {
namespace {

StressTangent tangent(const FlowLaw& law, double q, const Point& at) {
  const EquivalentRate f = law.equivalent_rate(q == 0.0 ? vanishing_stress : q, at);
  return coaxial_tangent(q, f.value, f.slope);
}

}  // namespace

void FlowLaw::rate(const Point& at, double* strain_rate, double* /*internal_rate*/) const {
  const Deviator now = deviator(at.stress);
  if (now.q > 0.0) add_flow(now, equivalent_rate(now.q, at).value, strain_rate);
}

void FlowLaw::derivative(const Point& at, const double* d_stress, const double* /*d_state*/,
                         const double* /*d_internal*/, double* d_strain_rate, double* /*d_internal_rate*/) const {
  const Deviator now = deviator(at.stress);
  add_tangent(now, tangent(*this, now.q, at), tensor::deviator(Eigen::Map<const Tensor6>(d_stress)), d_strain_rate);
}

StressTangent FlowLaw::stress_tangent(const Point& at) const {
  return tangent(*this, deviator(at.stress).q, at);
}

}  // namespace creepcontact::material
