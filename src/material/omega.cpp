#include "omega.hpp"

#include "arrhenius.hpp"

namespace creepcontact::material {

Omega::Omega(Function activation, Function rate0, Function omega, double min_stress,
             const OmegaCorrections& corrections)
    : ScalarStateLaw({std::move(activation)}),
      rate0_(std::move(rate0), min_stress, BelowRange::proportional),
      omega_(std::move(omega), min_stress, BelowRange::constant),
      corrections_(corrections),
      rate_factor_(std::pow(10.0, -corrections.delta_sr)),
      omega_factor_(std::pow(10.0, corrections.delta_cd)) {
  if (corrections.multiaxial && min_stress == 0.0)
    throw ParameterError("min_stress", "the number 0",
                         "with multiaxial = \"api_579\" a stress > 0: at vanishing von Mises stress the ratio of the "
                         "mean stress to it has no limit");
}

bool Omega::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  const bool is_damage = &variable == &material::damage;
  if (!is_damage && &variable != &material::remaining_life) return false;
  const double q = deviator(at.stress).q, eps = at.internal[0];
  into[0] = 0;
  if (q == 0.0) {
    if (is_damage && eps > 0.0) {
      const ScalarStress<double> none{vanishing_stress, 0.0};
      into[0] = -std::expm1(-effective_omega(none, at.temperature) * eps);
    }
    return true;
  }
  const ScalarStress<double> stress{q, tensor::trace(at.stress)};
  const double omega = effective_omega(stress, at.temperature);
  if (is_damage)
    into[0] = eps > 0.0 ? -std::expm1(-omega * eps) : 0.0;
  else
    into[0] = omega * rates(stress, std::array{eps}, at).strain;
  return true;
}

LawInfo omega_info() {
  enum Key { rate0, omega, min_stress, multiaxial, alpha, beta, delta_sr, delta_cd, activation_energy };
  const auto number = [](const char* key, const std::string& meaning, double low, double high, double value) {
    return ParameterInfo{.key = key,
                         .description = meaning,
                         .minimum = low,
                         .strict = false,
                         .fallback = {{value}},
                         .variables = {},
                         .maximum = high};
  };
  const double any = std::numeric_limits<double>::infinity();
  return {
      "omega",
      "rate = rate0 exp(omega eps); rupture at 1/(omega rate0)",
      "M. Prager, 1995; API 579-1/ASME FFS-1, Part 10",
      with_arrhenius(
          {{.key = "rate0",
            .description = "equivalent rate of the virgin material, a function of the von Mises stress "
                           "q and temperature T [1/time]",
            .strict = false,
            .variables = {"q", "T"}},
           {.key = "omega",
            .description = "how much the logarithm of the rate grows per creep strain, a function of q "
                           "and T [-]",
            .variables = {"q", "T"}},
           min_stress_key("`rate0` is proportional to q and `omega` constant"),
           {.key = "multiaxial",
            .description = "`\"api_579\"`: omega is replaced by max(omega - n, 3)^(1 + delta) + alpha_omega n, delta = "
                           "beta_omega ((sigma_1 + sigma_2 + sigma_3)/q - 1), n = d(log rate0)/d(log q)",
            .fallback = {{0.0}},
            .words = {"none", "api_579"}},
           number("alpha_omega", "of the multiaxial correction: 1, 2 (pressurised cylinder) or 3 (sphere) [-]", 0, any,
                  1),
           number("beta_omega", "of the multiaxial correction [-]", 0, any, 0.33),
           number("delta_sr", "scatter: `rate0` is multiplied by 10^-delta_sr; -0.5 is the fastest creep [-]", -0.5,
                  0.5, 0),
           number("delta_cd", "ductility: `omega` is multiplied by 10^delta_cd; -0.3 is ductile, 0.3 brittle [-]", -0.3,
                  0.3, 0)},
          "rate0"),
      [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
        const auto value = [&](Key key) { return p.at(key).at(0)({}); };
        const OmegaCorrections corrections{.multiaxial = value(multiaxial) == 1.0,
                                           .alpha = value(alpha),
                                           .beta = value(beta),
                                           .delta_sr = value(delta_sr),
                                           .delta_cd = value(delta_cd)};
        const std::size_t first = activation_energy;
        const Function activation = activated({{1.0}, p.at(first), p.at(first + 1), p.at(first + 2)}, {0}).at(0).at(0);
        return std::make_unique<Omega>(activation, p.at(rate0).at(0), p.at(omega).at(0), value(min_stress),
                                       corrections);
      },
      {&damage, &remaining_life}};
}

}  // namespace creepcontact::material
