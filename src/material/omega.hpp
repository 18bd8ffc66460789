#pragma once
/// The Omega method of the Material Properties Council: f = rate0 exp(omega eps), with eps the equivalent creep strain
/// that this mechanism has accumulated. At constant stress eps = -ln(1 - t/t_r)/omega, t_r = 1/(omega rate0) the time
/// to rupture. Damage D = 1 - exp(-omega eps), which is t/t_r there; remaining life at the present stress and
/// temperature (1 - D)/(omega rate0) = 1/(omega f). rate0 and omega are functions of q and T, such as the polynomials
/// in log q of API 579-1/ASME FFS-1, Part 10.
/// Source: M. Prager, J. Pressure Vessel Technol. 117 (1995), 95-103; API 579-1/ASME FFS-1, Part 10.

#include "creepcontact/material/registry.hpp"
#include "scalar_state_law.hpp"
#include "stress_function.hpp"

namespace creepcontact::material {

class Omega final : public ScalarStateLaw<Omega, 1> {
 public:
  /// @param activation  factor of rate0, of T, >= 0
  /// @param rate0  rate of the virgin material [1/time], of q and T, >= 0
  /// @param omega  [-], of q and T, > 0
  /// @param min_stress  below it rate0 is proportional to q, and omega constant; >= 0
  Omega(Function activation, Function rate0, Function omega, double min_stress)
      : ScalarStateLaw({std::move(activation)}),
        rate0_(std::move(rate0), min_stress, BelowRange::proportional),
        omega_(std::move(omega), min_stress, BelowRange::constant) {}
  std::string name() const override { return "omega"; }

  template <class Number>
  ScalarRates<Number, 1> rates(const Number& q, const std::array<Number, 1>& eps, const PointState& at) const {
    using std::exp;
    const Number f = at.parameters[0] * rate0_(q, at.temperature) * exp(omega_(q, at.temperature) * eps[0]);
    return {f, {f}};
  }

  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  StressFunction rate0_, omega_;
};

LawInfo omega_info();

}  // namespace creepcontact::material
