#include "kachanov_rabotnov.hpp"

#include "arrhenius.hpp"
#include "coaxial.hpp"
#include "power.hpp"
#include "stress_measure.hpp"

namespace creepcontact::material {
namespace {

constexpr double min_rest = 1e-14;  // of 1 - D

enum Parameter { A, n, B, r, phi, alpha, damage_energy };

}  // namespace

KachanovRabotnov::KachanovRabotnov(Function A, Function n, Function B, Function r, Function phi, Function alpha)
    : CreepLaw({std::move(A), std::move(n), std::move(B), std::move(r), std::move(phi), std::move(alpha)}) {
  const Function& exponent = parameters()[Parameter::phi];
  power_ = exponent.is_constant() ? exponent({}) + 1.0 : 1.0;
}

bool KachanovRabotnov::uses_mean_stress() const {
  return !parameters()[Parameter::alpha].is_zero();
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
  return {"kachanov_rabotnov",
          "rate = A (q/(1-w))^n, dw/dt = B S^r/(1-w)^phi, S = alpha max(sigma_1, 0) + (1-alpha) q",
          "L. M. Kachanov, 1958; Y. N. Rabotnov, 1969; D. R. Hayhurst, 1972",
          with_arrhenius({{"A", "rate at unit equivalent stress, undamaged [1/(time stress^n)]", 0.0, false},
                          {"n", "stress exponent [-]", 1.0, false},
                          {"B", "damage rate at unit stress, undamaged [1/(time stress^r)]", 0.0, false},
                          {"r", "stress exponent of damage [-]", 0.0, true},
                          {"phi", "damage exponent [-]", 0.0, false},
                          {.key = "alpha",
                           .description = "weight of the largest principal stress in S [-]",
                           .strict = false,
                           .fallback = {{0.0}},
                           .maximum = 1.0},
                          {.key = "damage_activation_energy",
                           .description = "activation energy of `B` [energy/mol]",
                           .strict = false,
                           .fallback = {{0.0}}}}),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated(activated(std::move(p), {A}), {B}, damage_energy);
            return std::make_unique<KachanovRabotnov>(p.at(0).at(0), p.at(1).at(0), p.at(2).at(0), p.at(3).at(0),
                                                      p.at(4).at(0), p.at(5).at(0));
          },
          {&damage, &remaining_life}};
}

}  // namespace creepcontact::material
