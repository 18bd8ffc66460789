#include "hereditary.hpp"

#include "lists.hpp"

namespace creepcontact::material {

Hereditary::Hereditary(std::string name, const ParameterValues& values)
    : CreepLaw(first(values, n_constants)),
      name_(std::move(name)),
      n_elements_(std::ssize(values[compliances])),
      volumetric_(!values[volumetric_compliances].empty()) {
  std::vector<NamedList> lists{{"compliances", &values[compliances]}, {"times", &values[times]}};
  if (volumetric_) lists.emplace_back("volumetric_compliances", &values[volumetric_compliances]);
  if (n_elements_ > 0 || volumetric_ || !values[times].empty()) require_one_length(lists);
}

Hereditary::Chain Hereditary::chain(const PointState& at) const {
  const std::span<const double> dashpot = list(fluidity, at);
  return {dashpot.empty() ? 0.0 : dashpot[0], list(compliances, at), list(times, at), list(volumetric_compliances, at)};
}

Tensor6 Hereditary::Chain::limit(int element, const tensor::ConstMap& stress) const {
  Tensor6 result = 1.5 * J[element] * tensor::deviator(stress);
  if (!B.empty()) result.head<3>().array() += B[element] / 9.0 * tensor::trace(stress);
  return result;
}

void Hereditary::rate(const PointState& at, PointRate into) const {
  const Chain chain = this->chain(at);
  for (int i = 0; i < n_elements_; ++i) {
    tensor::Map own = tensor::writable(into.internal, i);
    own = (chain.limit(i, at.stress) - tensor::view(at.internal, i)) / chain.tau[i];
    into.creep_strain += own;
  }
  if (chain.fluidity > 0.0) into.creep_strain += 1.5 * chain.fluidity * tensor::deviator(at.stress);
}

void Hereditary::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  // The law is linear in stress and strains.
  rate({.stress = change.stress, .internal = change.internal, .parameters = at.parameters}, into);
}

StressTangent Hereditary::stress_tangent(const PointState& at) const {
  const Chain chain = this->chain(at);
  StressTangent c{1.5 * chain.fluidity, 0.0, 0.0};
  for (int i = 0; i < n_elements_; ++i) {
    c.deviatoric += 1.5 * chain.J[i] / chain.tau[i];
    if (volumetric_) c.volumetric += chain.B[i] / (3.0 * chain.tau[i]);
  }
  return c;
}

void Hereditary::increment(const PointState& at, double duration, PointIncrement into) const {
  const Chain chain = this->chain(at);
  for (int i = 0; i < n_elements_; ++i) {
    const Tensor6 change =
        -std::expm1(-duration / chain.tau[i]) * (chain.limit(i, at.stress) - tensor::view(at.internal, i));
    tensor::writable(into.internal, i) += change;
    into.creep_strain += change;
  }
  into.creep_strain += 1.5 * chain.fluidity * duration * tensor::deviator(at.stress);
}

bool Hereditary::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &kelvin_strain || n_elements_ == 0) return false;
  tensor::Map sum = tensor::writable(into, 0);
  sum.setZero();
  for (int i = 0; i < n_elements_; ++i) sum += tensor::view(at.internal, i);
  return true;
}

}  // namespace creepcontact::material
