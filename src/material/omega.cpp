#include "omega.hpp"

#include "arrhenius.hpp"

namespace creepcontact::material {

bool Omega::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  const bool is_damage = &variable == &material::damage;
  if (!is_damage && &variable != &material::remaining_life) return false;
  const double q = deviator(at.stress).q, eps = at.internal[0];
  into[0] = 0;
  if (q == 0.0) {
    if (is_damage && eps > 0.0) into[0] = -std::expm1(-omega_(vanishing_stress, at.temperature) * eps);
    return true;
  }
  const double omega = omega_(q, at.temperature);
  if (is_damage)
    into[0] = eps > 0.0 ? -std::expm1(-omega * eps) : 0.0;
  else
    into[0] = omega * rates(q, std::array{eps}, at).strain;
  return true;
}

LawInfo omega_info() {
  return {"omega",
          "rate = rate0 exp(omega eps); rupture at 1/(omega rate0)",
          "M. Prager, 1995; API 579-1/ASME FFS-1, Part 10",
          with_arrhenius({{.key = "rate0",
                           .description = "equivalent rate of the virgin material, a function of the von Mises stress "
                                          "q and temperature T [1/time]",
                           .strict = false,
                           .variables = {"q", "T"}},
                          {.key = "omega",
                           .description = "how much the logarithm of the rate grows per creep strain, a function of q "
                                          "and T [-]",
                           .variables = {"q", "T"}},
                          min_stress_key("`rate0` is proportional to q and `omega` constant")},
                         "rate0"),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            const Function activation = activated({{1.0}, p.at(3), p.at(4), p.at(5)}, {0}).at(0).at(0);
            return std::make_unique<Omega>(activation, p.at(0).at(0), p.at(1).at(0), p.at(2).at(0)({}));
          },
          {&damage, &remaining_life}};
}

}  // namespace creepcontact::material
