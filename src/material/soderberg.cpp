#include "soderberg.hpp"

#include <algorithm>

#include "arrhenius.hpp"
#include "hardening_law.hpp"

namespace creepcontact::material {

void Soderberg::increment(const PointState& at, double duration, PointIncrement into) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const auto& of = at.parameters;
  const double growth = -std::expm1(-of[r] * duration) * std::max(of[C] * power(now.q, of[p]) - at.internal[0], 0.0);
  add_flow(now, growth + of[A] * power(now.q, of[n]) * duration, into.creep_strain);
  into.internal[0] += growth;
}

bool Soderberg::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &hardening_strain) return false;
  into[0] = at.internal[0];
  return true;
}

LawInfo soderberg_info() {
  return {
      "soderberg",
      "strain at constant stress = C q^p (1 - exp(-r t)) + A q^n t",
      "C. R. Soderberg, 1936",
      with_arrhenius(law_table(
          Row<Soderberg::C>{{.key = "C",
                             .description = "limit of the primary creep strain at unit equivalent stress [1/stress^p]",
                             .dimension = unit::none / unit::pow(unit::stress, Soderberg::p),
                             .strict = false}},
          Row<Soderberg::p>{stress_exponent("p", "stress exponent of this limit [-]")},
          Row<Soderberg::r>{{.key = "r",
                             .description = "rate at which primary creep ends [1/time]",
                             .dimension = unit::per_time,
                             .activation = Activation::rate}},
          Row<Soderberg::A>{{.key = "A",
                             .description = "steady rate at unit equivalent stress [1/(time stress^n)]",
                             .dimension = unit::per_time / unit::pow(unit::stress, Soderberg::n),
                             .strict = false,
                             .activation = Activation::rate}},
          Row<Soderberg::n>{stress_exponent("n", "stress exponent of the steady rate [-]")})),
      construct<Soderberg>,
      {&hardening_strain}};
}

}  // namespace creepcontact::material
