#include "hayhurst.hpp"

#include <algorithm>
#include <cmath>

#include "coaxial.hpp"

namespace creepcontact::material {
namespace {

constexpr double min_integrity = 1e-14;  // of 1 - D and 1 - phi

/// 1 - z, and its derivative.
struct IntactPart {
  explicit IntactPart(double z) : value(std::max(1.0 - z, min_integrity)), slope(value > min_integrity ? -1.0 : 0.0) {}
  double value, slope;
};

ParameterValues with_stress_scale(const ParameterValues& values) {
  ParameterValues result = first(values, Hayhurst::damage_stress);
  if (!result[Hayhurst::sigma0].empty()) return result;
  if (!result[Hayhurst::A].at(0).is_zero())
    throw ParameterError("sigma0", "the stress 'sigma0' is missing", "with the damage rate factor A a stress > 0");
  result[Hayhurst::sigma0] = {1.0};  // of no damage
  return result;
}

}  // namespace

Hayhurst::Hayhurst(const ParameterValues& values)
    : CreepLaw(with_stress_scale(values)), tension_(DamagingTension(values[damage_stress].at(0)({}))) {}

bool Hayhurst::uses_mean_stress() const {
  return !parameters()[A].is_zero() && !parameters()[alpha].is_zero();
}

Hayhurst::Flow Hayhurst::flow(double q, const PointState& at) {
  const std::span<const double> p = at.parameters, z = at.internal;
  const IntactPart unaged(z[ageing]), whole(z[damage_variable]);
  const double per_q = (1.0 - z[hardening] - z[softening]) / (p[K] * unaged.value * whole.value);
  const double per_hardening = -q / (p[K] * unaged.value * whole.value);
  const double f = p[rate0] * std::sinh(per_q * q), slope = p[rate0] * std::cosh(per_q * q);
  return {f,
          slope * per_q,
          {slope * per_hardening, slope * per_hardening, -slope * per_q * q * unaged.slope / unaged.value,
           -slope * per_q * q * whole.slope / whole.value}};
}

void Hayhurst::rate(const PointState& at, PointRate into) const {
  const std::span<const double> p = at.parameters, z = at.internal;
  const Deviator now = deviator(at.stress);
  std::ranges::fill(into.internal, 0.0);
  if (now.q > 0.0) {
    const double f = flow(now.q, at).f;
    add_flow(now, f, into.creep_strain);
    into.internal[hardening] = p[h1] / now.q * (p[H1_limit] - p[delta1] * z[hardening]) * f;
    into.internal[softening] = p[h2] / now.q * (p[H2_limit] - p[delta2] * z[softening]) * f;
  }
  into.internal[ageing] = p[kc] / 3.0 * std::pow(IntactPart(z[ageing]).value, 4);
  if (p[A] > 0.0) {
    const double S = StressMeasure(at.stress, p[alpha], tension_).value;
    into.internal[damage_variable] = p[A] * std::sinh(S / p[sigma0]);
  }
}

void Hayhurst::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const std::span<const double> p = at.parameters, z = at.internal;
  const Deviator now = deviator(at.stress);
  const Tensor6 ds = tensor::deviator(change.stress);
  add_tangent(now, stress_tangent(at), ds, into.creep_strain);
  std::ranges::fill(into.internal, 0.0);
  if (now.q > 0.0) {
    const Flow of = flow(now.q, at);
    double by_variables = 0;
    for (std::size_t i = 0; i < n_variables; ++i) by_variables += of.by[i] * change.internal[i];
    add_flow(now, by_variables, into.creep_strain);
    const double dq = 1.5 * now.s.dot(ds) / now.q;
    const double secant = of.f / now.q;
    const double d_secant = (of.by_q * dq + by_variables - secant * dq) / now.q;
    into.internal[hardening] =
        p[h1] * ((p[H1_limit] - p[delta1] * z[hardening]) * d_secant - p[delta1] * change.internal[hardening] * secant);
    into.internal[softening] =
        p[h2] * ((p[H2_limit] - p[delta2] * z[softening]) * d_secant - p[delta2] * change.internal[softening] * secant);
  }
  const IntactPart unaged(z[ageing]);
  into.internal[ageing] = 4.0 / 3.0 * p[kc] * std::pow(unaged.value, 3) * unaged.slope * change.internal[ageing];
  if (p[A] == 0.0) return;
  const StressMeasure S(at.stress, p[alpha], tension_);
  into.internal[damage_variable] = p[A] * std::cosh(S.value / p[sigma0]) / p[sigma0] * S.gradient.dot(change.stress);
}

StressTangent Hayhurst::stress_tangent(const PointState& at) const {
  const double q = deviator(at.stress).q;
  const Flow of = flow(q, at);
  return coaxial_tangent(q, of.f, of.by_q);
}

bool Hayhurst::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &material::damage) return false;
  into[0] = std::min(at.internal[damage_variable], 1.0);
  return true;
}

LawInfo hayhurst_info() {
  using Law = Hayhurst;
  const double any = -std::numeric_limits<double>::infinity();
  const auto optional = [](const char* key, const std::string& meaning, const UnitPowers& dimension, double minimum,
                           double value) {
    return ParameterInfo{.key = key,
                         .description = meaning,
                         .dimension = dimension,
                         .minimum = minimum,
                         .strict = false,
                         .fallback = {{value}}};
  };
  return {
      "hayhurst",
      "rate = rate0 sinh(q (1-H1-H2)/(K (1-phi) (1-D))), dHi = (hi/q) (Hi_limit - delta_i Hi) d eps, dphi/dt = kc/3 "
      "(1-phi)^4, dD/dt = A sinh(S/sigma0), S = alpha max(sigma_1, 0) + (1-alpha) q",
      "Z. L. Kowalewski, D. R. Hayhurst, B. F. Dyson, 1994; code_aster, R5.03.13",
      law_table(
          Row<Law::rate0>{
              {.key = "rate0", .description = "rate factor, EPS0 of code_aster [1/time]", .dimension = unit::per_time}},
          Row<Law::K>{{.key = "K", .description = "resistance, K of code_aster [stress]", .dimension = unit::stress}},
          Row<Law::h1>{{.key = "h1",
                        .description = "modulus of the primary hardening H1, H1 of code_aster [stress]",
                        .dimension = unit::stress,
                        .strict = false}},
          Row<Law::H1_limit>{{.key = "H1_limit",
                              .description = "H1 saturates at H1_limit/delta1, H1ST of code_aster [-]",
                              .dimension = unit::none,
                              .strict = false,
                              .maximum = 1.0}},
          Row<Law::sigma0>{{.key = "sigma0",
                            .description = "stress scale of the damage, SIG0 of code_aster; required with `A` [stress]",
                            .dimension = unit::stress,
                            .fallback = std::vector<Function>{}}},
          Row<Law::delta1>{
              optional("delta1", "recovery of H1, DELTA1 of code_aster; 0: H1 has no limit [-]", unit::none, 0, 1)},
          Row<Law::h2>{optional("h2",
                                "modulus of the second hardening H2, H2 of code_aster; negative: softening [stress]",
                                unit::stress, any, 0)},
          Row<Law::H2_limit>{
              optional("H2_limit", "H2 saturates at H2_limit/delta2, H2ST of code_aster [-]", unit::none, any, 1)},
          Row<Law::delta2>{
              optional("delta2", "recovery of H2, DELTA2 of code_aster; 0: H2 has no limit [-]", unit::none, 0, 0)},
          Row<Law::kc>{optional("kc", "rate of ageing, KC of code_aster [1/time]", unit::per_time, 0, 0)},
          Row<Law::A>{optional("A", "damage rate factor, BIGA of code_aster [1/time]", unit::per_time, 0, 0)},
          Row<Law::alpha>{{.key = "alpha",
                           .description = "weight of the tension in S, ALPHAD of code_aster [-]",
                           .dimension = unit::none,
                           .strict = false,
                           .fallback = {{0.5}},
                           .maximum = 1.0}},
          Row<Law::damage_stress>{
              {.key = "damage_stress",
               .description = "tension in S: largest principal stress, or trace of the stress (S_EQUI_D of code_aster "
                              "not 0)",
               .dimension = unit::none,
               .fallback = {{0.0}},
               .words = {"principal", "trace"}}}),
      construct<Law>,
      {&damage}};
}

}  // namespace creepcontact::material
