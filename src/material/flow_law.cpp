#include "creepcontact/material/flow_law.hpp"

namespace creepcontact::material {
namespace {

using ConstMap = Eigen::Map<const Tensor6>;
using Map = Eigen::Map<Tensor6>;

// Stands for q -> 0 where only the limit of df/dq is wanted; far below any stress, far above underflow.
constexpr double vanishing_stress = 1e-150;

struct Deviator {
  Tensor6 s;
  double q;
};

Deviator deviator(const double* stress) {
  Deviator d{tensor::deviator(ConstMap(stress)), 0.0};
  d.q = std::sqrt(1.5) * d.s.norm();
  return d;
}

StressTangent tangent(const FlowLaw& law, double q, const Point& at) {
  if (q == 0.0) return {1.5 * law.equivalent_rate(vanishing_stress, at).slope, 0.0, 0.0};  // f/q -> df/dq
  const EquivalentRate f = law.equivalent_rate(q, at);
  const double secant = f.value / q;
  return {1.5 * secant, 1.5 * (f.slope - secant), 0.0};
}

}  // namespace

void FlowLaw::rate(const Point& at, double* strain_rate, double* /*internal_rate*/) const {
  const auto [s, q] = deviator(at.stress);
  if (q == 0.0) return;
  Map(strain_rate) += 1.5 * equivalent_rate(q, at).value / q * s;
}

void FlowLaw::derivative(const Point& at, const double* d_stress, const double* /*d_state*/,
                         const double* /*d_internal*/, double* d_strain_rate, double* /*d_internal_rate*/) const {
  const auto [s, q] = deviator(at.stress);
  const StressTangent c = tangent(*this, q, at);
  const Tensor6 ds = tensor::deviator(ConstMap(d_stress));
  Map(d_strain_rate) += c.deviatoric * ds;
  if (q > 0.0) Map(d_strain_rate) += c.radial * 1.5 * (s.dot(ds) / q / q) * s;  // |s|^2 = 2/3 q^2
}

StressTangent FlowLaw::stress_tangent(const Point& at) const {
  return tangent(*this, deviator(at.stress).q, at);
}

}  // namespace creepcontact::material
