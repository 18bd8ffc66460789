#include "garofalo.hpp"

#include "arrhenius.hpp"
#include "power.hpp"

namespace creepcontact::material {

EquivalentRate Garofalo::equivalent_rate(double q, const PointState& at) const {
  const double A = at.parameters[Constant::A], alpha = at.parameters[Constant::alpha], n = at.parameters[Constant::n];
  const double sinh = std::sinh(alpha * q);
  const double below = A * power(sinh, n - 1.0);
  return {below * sinh, n * alpha * below * std::cosh(alpha * q)};
}

LawInfo garofalo_info() {
  return {"garofalo", "rate = A sinh(alpha q)^n", "F. Garofalo, 1965",
          with_arrhenius(law_table(
              Row<Garofalo::A>{{.key = "A",
                                .description = "rate where sinh(alpha q) = 1 [1/time]",
                                .dimension = unit::per_time,
                                .strict = false,
                                .activation = Activation::rate}},
              Row<Garofalo::alpha>{{.key = "alpha",
                                    .description = "inverse of the stress where the power law breaks down [1/stress]",
                                    .dimension = unit::per_stress}},
              Row<Garofalo::n>{stress_exponent("n", "stress exponent at low stress [-]")})),
          construct<Garofalo>};
}

}  // namespace creepcontact::material
