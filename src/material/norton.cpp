#include "norton.hpp"

#include "arrhenius.hpp"
#include "power.hpp"

namespace creepcontact::material {

EquivalentRate Norton::equivalent_rate(double q, const PointState& at) const {
  const double A = at.parameters[0], n = at.parameters[1];
  const double secant = A * power(q, n - 1.0);
  return {secant * q, n * secant};
}

LawInfo norton_info() {
  return {"norton", "rate = A q^n", "F. H. Norton, 1929",
          with_arrhenius({{"A", "rate at unit equivalent stress [1/(time stress^n)]", 0.0, false},
                          {"n", "stress exponent [-]", 1.0, false}}),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated(std::move(p), {0});
            return std::make_unique<Norton>(p.at(0).at(0), p.at(1).at(0));
          }};
}

}  // namespace creepcontact::material
