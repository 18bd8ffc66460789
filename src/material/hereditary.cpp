#include "creepcontact/material/hereditary.hpp"

#include "lists.hpp"

namespace creepcontact::material {
namespace {

using ConstMap = Eigen::Map<const Tensor6>;
using Map = Eigen::Map<Tensor6>;

/// Fluidity first, then the lists.
std::vector<Function> all_parameters(const std::vector<Function>& J, const std::vector<Function>& tau,
                                     const std::vector<Function>& B, const Function& fluidity) {
  std::vector<Function> all{fluidity};
  if (J.empty() && tau.empty() && B.empty()) return all;  // a dashpot alone
  std::vector<NamedList> lists{{"compliances", &J}, {"times", &tau}};
  if (!B.empty()) lists.emplace_back("volumetric_compliances", &B);
  const std::vector<Function> chain = joined(lists);
  all.insert(all.end(), chain.begin(), chain.end());
  return all;
}

}  // namespace

Hereditary::Hereditary(std::string name, const std::vector<Function>& J, const std::vector<Function>& tau,
                       const std::vector<Function>& B, const Function& fluidity)
    : CreepLaw(all_parameters(J, tau, B, fluidity)),
      name_(std::move(name)),
      n_elements_(static_cast<int>(J.size())),
      volumetric_(!B.empty()) {}

Tensor6 Hereditary::limit(int element, const double* parameters, const double* stress) const {
  const double* J = parameters + 1 + element;
  Tensor6 result = 1.5 * J[0] * tensor::deviator(ConstMap(stress));
  if (volumetric_) result.head<3>().array() += J[2 * n_elements_] / 9.0 * tensor::trace(ConstMap(stress));
  return result;
}

void Hereditary::rate(const Point& at, double* strain_rate, double* internal_rate) const {
  Map sum(strain_rate);
  const double* tau = at.parameters + 1 + n_elements_;
  for (int i = 0; i < n_elements_; ++i) {
    Map own(internal_rate + 6 * i);
    own = (limit(i, at.parameters, at.stress) - ConstMap(at.internal + 6 * i)) / tau[i];
    sum += own;
  }
  if (const double fluidity = at.parameters[0]; fluidity > 0.0)
    sum += 1.5 * fluidity * tensor::deviator(ConstMap(at.stress));
}

void Hereditary::derivative(const Point& at, const double* d_stress, const double* /*d_state*/,
                            const double* d_internal, double* d_strain_rate, double* d_internal_rate) const {
  // The law is linear in stress and strains.
  Point change = at;
  change.stress = d_stress;
  change.internal = d_internal;
  rate(change, d_strain_rate, d_internal_rate);
}

StressTangent Hereditary::stress_tangent(const Point& at) const {
  StressTangent c{1.5 * at.parameters[0], 0.0, 0.0};
  const double *J = at.parameters + 1, *tau = J + n_elements_, *B = tau + n_elements_;
  for (int i = 0; i < n_elements_; ++i) {
    c.deviatoric += 1.5 * J[i] / tau[i];
    if (volumetric_) c.volumetric += B[i] / (3.0 * tau[i]);
  }
  return c;
}

void Hereditary::increment(const Point& at, double duration, double* strain, double* internal) const {
  Map sum(strain);
  const double* tau = at.parameters + 1 + n_elements_;
  for (int i = 0; i < n_elements_; ++i) {
    const Tensor6 change =
        -std::expm1(-duration / tau[i]) * (limit(i, at.parameters, at.stress) - ConstMap(at.internal + 6 * i));
    Map(internal + 6 * i) += change;
    sum += change;
  }
  sum += 1.5 * at.parameters[0] * duration * tensor::deviator(ConstMap(at.stress));
}

}  // namespace creepcontact::material
