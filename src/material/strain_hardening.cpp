#include "strain_hardening.hpp"

#include "arrhenius.hpp"
#include "constant_parameter.hpp"
#include "power.hpp"

namespace creepcontact::material {

StrainHardening::StrainHardening(std::string name, const ParameterValues& values)
    : HardeningLaw(first(values, power_law::n_constants), true), name_(std::move(name)) {
  require_constant("m", parameters()[power_law::m], 0.0, 1.0);
}

double StrainHardening::equivalent_rate(double q, double eps, const PointState& at) const {
  const double A = at.parameters[power_law::A], n = at.parameters[power_law::n], m = at.parameters[power_law::m];
  const double strain = A * power(q, n);  // after the unit of time; A^(1/m) alone may underflow
  return m * strain * std::pow(strain / eps, 1.0 / m - 1.0);
}

HardeningRate StrainHardening::linearized_rate(double q, double eps, const PointState& at) const {
  const double n = at.parameters[power_law::n], m = at.parameters[power_law::m];
  const double f = equivalent_rate(q, eps, at);
  return {f, f * n / (m * q), f * (1.0 - 1.0 / m) / eps};
}

double StrainHardening::accumulated(double q, double eps, const PointState& at, double duration) const {
  const double A = at.parameters[power_law::A], n = at.parameters[power_law::n], m = at.parameters[power_law::m];
  const double strain = A * power(q, n);
  const double virgin = strain * std::pow(duration, m);
  // (eps^(1/m) + strain^(1/m) duration)^m - eps, from the side that loses no digits.
  if (virgin > eps) return virgin * std::pow(1.0 + std::pow(eps / virgin, 1.0 / m), m) - eps;
  if (eps == 0.0) return 0.0;
  return eps * std::expm1(m * std::log1p(std::pow(virgin / eps, 1.0 / m)));
}

LawInfo strain_hardening_info() {
  return {"strain_hardening",
          "rate = m A^(1/m) q^(n/m) eps^(1-1/m)",
          "A. Nadai, 1937",
          with_arrhenius(law_table(Row<power_law::A>{power_law::factor()}, Row<power_law::n>{stress_exponent()},
                                   Row<power_law::m>{{.key = "m",
                                                      .description = "time exponent [-], not a function of T",
                                                      .dimension = unit::none,
                                                      .variables = {},
                                                      .maximum = 1.0}})),
          [](const ParameterValues& values) -> std::unique_ptr<CreepLaw> {
            return std::make_unique<StrainHardening>("strain_hardening", values);
          },
          {&hardening_strain}};
}

}  // namespace creepcontact::material
