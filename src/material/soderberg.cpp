#include "soderberg.hpp"

#include <algorithm>

#include "arrhenius.hpp"
#include "hardening_law.hpp"

namespace creepcontact::material {

void Soderberg::increment(const PointState& at, double duration, PointIncrement into) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const auto [C, p, r, A, n] = constants(at);
  const double growth = -std::expm1(-r * duration) * std::max(C * power(now.q, p) - at.internal[0], 0.0);
  add_flow(now, growth + A * power(now.q, n) * duration, into.creep_strain);
  into.internal[0] += growth;
}

bool Soderberg::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &hardening_strain) return false;
  into[0] = at.internal[0];
  return true;
}

LawInfo soderberg_info() {
  return {"soderberg",
          "strain at constant stress = C q^p (1 - exp(-r t)) + A q^n t",
          "C. R. Soderberg, 1936",
          with_arrhenius({{"C", "limit of the primary creep strain at unit equivalent stress [1/stress^p]", 0.0, false},
                          {"p", "stress exponent of this limit [-]", 1.0, false},
                          {"r", "rate at which primary creep ends [1/time]", 0.0, true},
                          {"A", "steady rate at unit equivalent stress [1/(time stress^n)]", 0.0, false},
                          {"n", "stress exponent of the steady rate [-]", 1.0, false}},
                         "r and A"),
          [](ParameterValues v) -> std::unique_ptr<CreepLaw> {
            v = activated(std::move(v), {2, 3});
            return std::make_unique<Soderberg>(v.at(0).at(0), v.at(1).at(0), v.at(2).at(0), v.at(3).at(0),
                                               v.at(4).at(0));
          },
          {&hardening_strain}};
}

}  // namespace creepcontact::material
