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

Hereditary::Limits::Limits(const Chain& chain, const tensor::ConstMap& stress)
    : chain_(chain), deviator_(1.5 * tensor::deviator(stress)), mean_(tensor::trace(stress) / 9.0) {}

inline Tensor6 Hereditary::Limits::of(int element) const {
  Tensor6 result = chain_.J[element] * deviator_;
  if (!chain_.B.empty()) result.head<3>().array() += chain_.B[element] * mean_;
  return result;
}

void Hereditary::rate(const PointState& at, PointRate into) const {
  const Chain chain = this->chain(at);
  const Limits limits(chain, at.stress);
  Tensor6 sum = chain.fluidity * limits.deviator();
  for (int i = 0; i < n_elements_; ++i) {
    const Tensor6 own = (limits.of(i) - tensor::view(at.internal, i)) * (1 / chain.tau[i]);
    tensor::writable(into.internal, i) = own;
    sum += own;
  }
  into.creep_strain += sum;
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
  const Limits limits(chain, at.stress);
  for (int i = 0; i < n_elements_; ++i) {
    const Tensor6 change = -std::expm1(-duration / chain.tau[i]) * (limits.of(i) - tensor::view(at.internal, i));
    tensor::writable(into.internal, i) += change;
    into.creep_strain += change;
  }
  into.creep_strain += chain.fluidity * duration * limits.deviator();
}

bool Hereditary::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &kelvin_strain || n_elements_ == 0) return false;
  tensor::Map sum = tensor::writable(into, 0);
  sum.setZero();
  for (int i = 0; i < n_elements_; ++i) sum += tensor::view(at.internal, i);
  return true;
}

}  // namespace creepcontact::material
