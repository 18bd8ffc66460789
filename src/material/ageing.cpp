#include "ageing.hpp"

#include "arrhenius.hpp"
#include "power.hpp"

namespace creepcontact::material {

EquivalentRate Ageing::equivalent_rate(double q, const PointState& at) const {
  const double A = at.parameters[power_law::A], n = at.parameters[power_law::n], m = at.parameters[power_law::m];
  const double secant = A * power(q, n - 1.0) * std::pow(at.time, m);
  return {secant * q, n * secant};
}

LawInfo ageing_info() {
  return {"ageing", "strain = A q^n t^m", "C. R. Soderberg, 1936",
          with_arrhenius(
              law_table(Row<power_law::A>{power_law::factor()}, Row<power_law::n>{stress_exponent()},
                        Row<power_law::m>{{.key = "m", .description = "time exponent [-]", .dimension = unit::none}})),
          construct<Ageing>};
}

}  // namespace creepcontact::material
