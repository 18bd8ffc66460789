#include "kachanov_rabotnov.hpp"

#include "arrhenius.hpp"
#include "coaxial.hpp"
#include "power.hpp"
#include "stress_measure.hpp"

namespace creepcontact::material {
namespace {

constexpr double min_rest = 1e-14;  // of 1 - D

}  // namespace

KachanovRabotnov::KachanovRabotnov(const ParameterValues& values) : CreepLaw(first(values, damage_energy)) {
  const Function& exponent = parameters()[phi];
  power_ = exponent.is_constant() ? exponent({}) + 1.0 : 1.0;
}

bool KachanovRabotnov::uses_mean_stress() const {
  return !parameters()[alpha].is_zero();
}

KachanovRabotnov::Integrity KachanovRabotnov::integrity(const PointState& at) const {
  const double rest = 1.0 - at.internal[0];
  const bool ruptured = rest < min_rest;
  const double value = std::pow(ruptured ? min_rest : rest, 1.0 / power_);
  return {value, ruptured ? 0.0 : -value / (power_ * rest)};
}

void KachanovRabotnov::rate(const PointState& at, PointRate into) const {
  const std::span<const double> p = at.parameters;
  const double whole = integrity(at).value;
  const Deviator now = deviator(at.stress);
  if (now.q > 0.0) add_flow(now, p[A] * power(now.q / whole, p[n]), into.creep_strain);
  const double S = p[alpha] > 0.0 ? StressMeasure(at.stress, p[alpha]).value : now.q;
  into.internal[0] = power_ * std::pow(whole, power_ - 1.0 - p[phi]) * p[B] * power(S, p[r]);
}

void KachanovRabotnov::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const std::span<const double> p = at.parameters;
  const Integrity whole = integrity(at);
  const Deviator now = deviator(at.stress);
  add_tangent(now, stress_tangent(at), tensor::deviator(change.stress), into.creep_strain);
  const double d_whole = whole.slope * change.internal[0];
  if (now.q > 0.0)
    add_flow(now, -p[n] * p[A] * power(now.q / whole.value, p[n]) / whole.value * d_whole, into.creep_strain);

  into.internal[0] = 0.0;
  const StressMeasure S(at.stress, p[alpha]);
  if (S.value == 0.0) return;
  const double exponent = power_ - 1.0 - p[phi];
  const double rate = power_ * std::pow(whole.value, exponent) * p[B] * power(S.value, p[r]);
  into.internal[0] = rate * (p[r] / S.value * S.gradient.dot(change.stress) + exponent / whole.value * d_whole);
}

StressTangent KachanovRabotnov::stress_tangent(const PointState& at) const {
  const std::span<const double> p = at.parameters;
  const double whole = integrity(at).value;
  const double q = deviator(at.stress).q;
  const double secant = p[A] * power((q == 0.0 ? vanishing_stress : q) / whole, p[n] - 1.0) / whole;
  return coaxial_tangent(q, secant * q, p[n] * secant);
}

bool KachanovRabotnov::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable == &material::damage) {
    into[0] = 1.0 - integrity(at).value;
    return true;
  }
  if (&variable != &material::remaining_life) return false;
  const std::span<const double> p = at.parameters;
  const double S = StressMeasure(at.stress, p[alpha]).value;
  into[0] = S > 0.0 ? (p[phi] + 1.0) * p[B] * power(S, p[r]) / std::pow(integrity(at).value, p[phi] + 1.0) : 0.0;
  return true;
}

LawInfo kachanov_rabotnov_info() {
  using Law = KachanovRabotnov;
  return {
      "kachanov_rabotnov",
      "rate = A (q/(1-w))^n, dw/dt = B S^r/(1-w)^phi, S = alpha max(sigma_1, 0) + (1-alpha) q",
      "L. M. Kachanov, 1958; Y. N. Rabotnov, 1969; D. R. Hayhurst, 1972",
      with_arrhenius(law_table(
          Row<Law::A>{{.key = "A",
                       .description = "rate at unit equivalent stress, undamaged [1/(time stress^n)]",
                       .dimension = unit::per_time / unit::pow(unit::stress, Law::n),
                       .strict = false,
                       .activation = Activation::rate}},
          Row<Law::n>{stress_exponent()},
          Row<Law::B>{{.key = "B",
                       .description = "damage rate at unit stress, undamaged [1/(time stress^r)]",
                       .dimension = unit::per_time / unit::pow(unit::stress, Law::r),
                       .strict = false,
                       .activation = Activation::rate,
                       .energy = Law::damage_energy}},
          Row<Law::r>{{.key = "r", .description = "stress exponent of damage [-]", .dimension = unit::none}},
          Row<Law::phi>{{.key = "phi", .description = "damage exponent [-]", .dimension = unit::none, .strict = false}},
          Row<Law::alpha>{{.key = "alpha",
                           .description = "weight of the largest principal stress in S [-]",
                           .dimension = unit::none,
                           .strict = false,
                           .fallback = {{0.0}},
                           .maximum = 1.0}},
          Row<Law::damage_energy>{{.key = "damage_activation_energy",
                                   .description = "activation energy of `B` [energy/mol]",
                                   .dimension = unit::none,
                                   .strict = false,
                                   .fallback = {{0.0}}}})),
      construct<Law>,
      {&damage, &remaining_life}};
}

}  // namespace creepcontact::material
