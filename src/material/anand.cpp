#include "anand.hpp"

#include <algorithm>
#include <cmath>

#include "arrhenius.hpp"
#include "coaxial.hpp"
#include "constant_parameter.hpp"
#include "viscoplastic_variables.hpp"

namespace creepcontact::material {
namespace {

constexpr double min_relative_resistance = 1e-6;  // of s0: trial states of an integrator below that count as this

}  // namespace

Anand::Anand(const ParameterValues& values) : CreepLaw(first(values, n_constants)) {
  require_constant("s0", parameters()[s0], 0.0);
}

Anand::Rates Anand::rates(double q, const PointState& at) {
  const std::span<const double> p = at.parameters;
  const bool vanishes = !(1.0 + at.internal[0] > min_relative_resistance);
  const double s = p[s0] * (vanishes ? min_relative_resistance : 1.0 + at.internal[0]);
  const double x = p[xi] * q / s;
  const double relative = std::pow(std::sinh(x), 1.0 / p[m]);  // f/A
  Rates r;
  r.flow = p[A] * relative;
  // x coth(x), which is 1 at x = 0
  const double steepness = x > 1e-8 ? x / std::tanh(x) : 1.0;
  r.flow_by_q = r.flow / p[m] * steepness / q;
  r.flow_by_s = vanishes ? 0.0 : -r.flow / p[m] * steepness / s;
  if (!(relative > 0.0) || p[h0] == 0.0) return r;
  const double s_star = p[s_hat] * std::pow(relative, p[n]);
  const double rest = 1.0 - s / s_star;
  const double slow = std::pow(std::abs(rest), p[a] - 1.0);  // |1 - s/s*|^(a-1)
  const double h = p[h0] / p[s0];
  r.growth = h * slow * rest * r.flow;
  // d(1 - s/s*) = (s/s*) (d ln s* - d ln s), and d ln s* = n/m x coth(x) d ln(q/s)
  const double d_rest_by_ln_q = s / s_star * p[n] / p[m] * steepness;
  const double d_rest_by_ln_s = -s / s_star - d_rest_by_ln_q;
  r.growth_by_q = h * slow * (rest * r.flow_by_q + p[a] * r.flow * d_rest_by_ln_q / q);
  r.growth_by_s = vanishes ? 0.0 : h * slow * (rest * r.flow_by_s + p[a] * r.flow * d_rest_by_ln_s / s);
  return r;
}

void Anand::rate(const PointState& at, PointRate into) const {
  const Deviator now = deviator(at.stress);
  into.internal[0] = 0.0;
  if (now.q == 0.0) return;
  const Rates r = rates(now.q, at);
  add_flow(now, r.flow, into.creep_strain);
  into.internal[0] = r.growth;
}

void Anand::derivative(const PointState& at, const PointChange& change, PointRate into) const {
  const Deviator now = deviator(at.stress);
  const Tensor6 ds = tensor::deviator(change.stress);
  const Rates r = rates(now.q == 0.0 ? vanishing_stress : now.q, at);
  add_tangent(now, coaxial_tangent(now.q, r.flow, r.flow_by_q), ds, into.creep_strain);
  into.internal[0] = 0.0;
  if (now.q == 0.0) return;
  const double d_resistance = at.parameters[s0] * change.internal[0];
  add_flow(now, r.flow_by_s * d_resistance, into.creep_strain);
  into.internal[0] = r.growth_by_q * 1.5 * now.s.dot(ds) / now.q + r.growth_by_s * d_resistance;
}

StressTangent Anand::stress_tangent(const PointState& at) const {
  const double q = deviator(at.stress).q;
  const Rates r = rates(q == 0.0 ? vanishing_stress : q, at);
  return coaxial_tangent(q, r.flow, r.flow_by_q);
}

bool Anand::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &drag_stress) return false;
  into[0] = at.parameters[s0] * (1.0 + at.internal[0]);
  return true;
}

LawInfo anand_info() {
  return {
      "anand",
      "rate = A sinh(xi q/s)^(1/m), ds = h0 |1-s/s*|^a sign(1-s/s*) d eps, s* = s_hat (rate/A)^n",
      "L. Anand, 1985; S. B. Brown, K. H. Kim, L. Anand, 1989",
      with_arrhenius(law_table(
          Row<Anand::A>{{.key = "A",
                         .description = "rate factor [1/time]",
                         .dimension = unit::per_time,
                         .activation = Activation::rate}},
          Row<Anand::xi>{{.key = "xi", .description = "multiplier of the stress [-]", .dimension = unit::none}},
          Row<Anand::m>{
              {.key = "m", .description = "strain rate sensitivity [-]", .dimension = unit::none, .maximum = 1.0}},
          Row<Anand::s_hat>{{.key = "s_hat",
                             .description = "coefficient of the resistance at saturation [stress]",
                             .dimension = unit::stress}},
          Row<Anand::n>{{.key = "n",
                         .description = "sensitivity of the resistance at saturation to the rate [-]",
                         .dimension = unit::none,
                         .strict = false}},
          Row<Anand::h0>{
              {.key = "h0", .description = "hardening modulus [stress]", .dimension = unit::stress, .strict = false}},
          Row<Anand::a>{{.key = "a",
                         .description = "exponent of the hardening [-]",
                         .dimension = unit::none,
                         .minimum = 1.0,
                         .strict = false}},
          Row<Anand::s0>{{.key = "s0",
                          .description = "resistance at first [stress]",
                          .dimension = unit::stress,
                          .variables = {}}})),
      construct<Anand>,
      {&drag_stress}};
}

}  // namespace creepcontact::material
