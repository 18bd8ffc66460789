#include "omega.hpp"

#include "arrhenius.hpp"

namespace creepcontact::material {

namespace {

OmegaCorrections corrections(const ParameterValues& values) {
  const auto number = [&](Omega::Constant constant) { return values[constant].at(0)({}); };
  return {.multiaxial = number(Omega::multiaxial) == 1.0,
          .alpha = number(Omega::alpha_omega),
          .beta = number(Omega::beta_omega),
          .delta_sr = number(Omega::delta_sr),
          .delta_cd = number(Omega::delta_cd)};
}

}  // namespace

Omega::Omega(const ParameterValues& values)
    : ScalarStateLaw({{activation_factor(values, n_constants)}}),
      rate0_(values[rate0].at(0), values[min_stress].at(0)({}), BelowRange::proportional),
      omega_(values[omega].at(0), values[min_stress].at(0)({}), BelowRange::constant),
      corrections_(corrections(values)),
      rate_factor_(std::pow(10.0, -corrections_.delta_sr)),
      omega_factor_(std::pow(10.0, corrections_.delta_cd)) {
  if (corrections_.multiaxial && rate0_.min_stress() == 0.0)
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
  const double effective = effective_omega(stress, at.temperature);
  if (is_damage)
    into[0] = eps > 0.0 ? -std::expm1(-effective * eps) : 0.0;
  else
    into[0] = effective * rates(stress, std::array{eps}, at).strain;
  return true;
}

LawInfo omega_info() {
  const auto number = [](const char* key, const std::string& meaning, double low, double high, double value) {
    return ParameterInfo{.key = key,
                         .description = meaning,
                         .dimension = unit::none,
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
      with_arrhenius(law_table(
          Row<Omega::rate0>{{.key = "rate0",
                             .description =
                                 "equivalent rate of the virgin material, a function of the von Mises stress "
                                 "q and temperature T [1/time]",
                             .dimension = unit::per_time,
                             .strict = false,
                             .variables = {"q", "T"},
                             .activation = Activation::by_law}},
          Row<Omega::omega>{{.key = "omega",
                             .description =
                                 "how much the logarithm of the rate grows per creep strain, a function of q "
                                 "and T [-]",
                             .dimension = unit::none,
                             .variables = {"q", "T"}}},
          Row<Omega::min_stress>{min_stress_key("`rate0` is proportional to q and `omega` constant")},
          Row<Omega::multiaxial>{
              {.key = "multiaxial",
               .description =
                   "`\"api_579\"`: omega is replaced by max(omega - n, 3)^(1 + delta) + alpha_omega n, delta = "
                   "beta_omega ((sigma_1 + sigma_2 + sigma_3)/q - 1), n = d(log rate0)/d(log q)",
               .dimension = unit::none,
               .fallback = {{0.0}},
               .words = {"none", "api_579"}}},
          Row<Omega::alpha_omega>{number(
              "alpha_omega", "of the multiaxial correction: 1, 2 (pressurised cylinder) or 3 (sphere) [-]", 0, any, 1)},
          Row<Omega::beta_omega>{number("beta_omega", "of the multiaxial correction [-]", 0, any, 0.33)},
          Row<Omega::delta_sr>{number("delta_sr",
                                      "scatter: `rate0` is multiplied by 10^-delta_sr; -0.5 is the fastest creep [-]",
                                      -0.5, 0.5, 0)},
          Row<Omega::delta_cd>{
              number("delta_cd", "ductility: `omega` is multiplied by 10^delta_cd; -0.3 is ductile, 0.3 brittle [-]",
                     -0.3, 0.3, 0)})),
      construct<Omega>,
      {&damage, &remaining_life}};
}

}  // namespace creepcontact::material
