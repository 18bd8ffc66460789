#include "ageing.hpp"

#include "arrhenius.hpp"
#include "power.hpp"

namespace creepcontact::material {

EquivalentRate Ageing::equivalent_rate(double q, const PointState& at) const {
  const double A = at.parameters[0], n = at.parameters[1], m = at.parameters[2];
  const double secant = A * power(q, n - 1.0) * std::pow(at.time, m);
  return {secant * q, n * secant};
}

LawInfo ageing_info() {
  return {"ageing", "strain = A q^n t^m", "C. R. Soderberg, 1936",
          with_arrhenius({{"A", "creep strain at unit equivalent stress and time [1/(time^m stress^n)]", 0.0, false},
                          {"n", "stress exponent [-]", 1.0, false},
                          {"m", "time exponent [-]", 0.0, true}}),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated(std::move(p), {0});
            return std::make_unique<Ageing>(p.at(0).at(0), p.at(1).at(0), p.at(2).at(0));
          }};
}

}  // namespace creepcontact::material
