#include "garofalo.hpp"

#include "arrhenius.hpp"
#include "power.hpp"

namespace creepcontact::material {

EquivalentRate Garofalo::equivalent_rate(double q, const PointState& at) const {
  const double A = at.parameters[0], alpha = at.parameters[1], n = at.parameters[2];
  const double sinh = std::sinh(alpha * q);
  const double below = A * power(sinh, n - 1.0);
  return {below * sinh, n * alpha * below * std::cosh(alpha * q)};
}

LawInfo garofalo_info() {
  return {"garofalo", "rate = A sinh(alpha q)^n", "F. Garofalo, 1965",
          with_arrhenius({{"A", "rate where sinh(alpha q) = 1 [1/time]", 0.0, false},
                          {"alpha", "inverse of the stress where the power law breaks down [1/stress]", 0.0, true},
                          {"n", "stress exponent at low stress [-]", 1.0, false}}),
          [](ParameterValues p) -> std::unique_ptr<CreepLaw> {
            p = activated(std::move(p), {0});
            return std::make_unique<Garofalo>(p.at(0).at(0), p.at(1).at(0), p.at(2).at(0));
          }};
}

}  // namespace creepcontact::material
