#pragma once
/// Theta projection: at constant stress and temperature the creep strain
///   theta_1 (1 - exp(-theta_2 t)) + theta_3 (exp(theta_4 t) - 1).
/// The theta_i are functions of q and T. The primary strain e_1 and the tertiary strain e_3 are states of their own:
///   d e_1/dt = theta_2 max(theta_1 - e_1, 0), d e_3/dt = theta_4 (theta_3 + e_3), f = d e_1/dt + d e_3/dt.
/// So after a change of stress or temperature both go on from the strain reached (strain hardening and softening).
/// Sources: R. W. Evans, B. Wilshire, Creep of Metals and Alloys (1985); R. W. Evans, J. D. Parker, B. Wilshire (1982).

#include "law_table.hpp"
#include "scalar_state_law.hpp"
#include "stress_function.hpp"

namespace creepcontact::material {

class ThetaProjection final : public ScalarStateLaw<ThetaProjection, 2> {
 public:
  /// All >= 0; theta_i are functions of q and T.
  enum Constant {
    theta_1,     ///< [-]
    theta_2,     ///< [1/time]
    theta_3,     ///< [-]
    theta_4,     ///< [1/time]
    min_stress,  ///< below it theta_2 and theta_4 are proportional to q, theta_1 and theta_3 constant
    n_constants
  };
  explicit ThetaProjection(const ParameterValues& values);
  std::string name() const override { return "theta_projection"; }

  template <class Number>
  ScalarRates<Number, 2> rates(const ScalarStress<Number>& stress, const std::array<Number, 2>& strain,
                               const PointState& at) const {
    const Number& q = stress.q;
    const double T = at.temperature;
    Number primary = theta_2_(q, T) * (theta_1_(q, T) - strain[0]);
    if (primary < 0.0) primary = 0.0 * q;
    const Number tertiary = theta_4_(q, T) * (theta_3_(q, T) + strain[1]);
    return {primary + tertiary, {primary, tertiary}};
  }

  void increment(const PointState& at, double duration, PointIncrement into) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  StressFunction theta_1_, theta_2_, theta_3_, theta_4_;
};

LawInfo theta_projection_info();

}  // namespace creepcontact::material
