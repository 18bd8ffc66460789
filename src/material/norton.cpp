#include "norton.hpp"

#include "arrhenius.hpp"
#include "power.hpp"

namespace creepcontact::material {

EquivalentRate Norton::equivalent_rate(double q, const PointState& at) const {
  const double A = at.parameters[Constant::A], n = at.parameters[Constant::n];
  const double secant = A * power(q, n - 1.0);
  return {secant * q, n * secant};
}

LawInfo norton_info() {
  return {"norton", "rate = A q^n", "F. H. Norton, 1929",
          with_arrhenius(law_table(Row<Norton::A>{{.key = "A",
                                                   .description = "rate at unit equivalent stress [1/(time stress^n)]",
                                                   .dimension = unit::per_time / unit::pow(unit::stress, Norton::n),
                                                   .strict = false,
                                                   .activation = Activation::rate}},
                                   Row<Norton::n>{stress_exponent()})),
          construct<Norton>};
}

}  // namespace creepcontact::material
