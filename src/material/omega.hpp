#pragma once
/// The Omega method of the Material Properties Council: f = rate0 exp(omega eps), with eps the equivalent creep strain
/// that this mechanism has accumulated. At constant stress eps = -ln(1 - t/t_r)/omega, t_r = 1/(omega rate0) the time
/// to rupture. Damage D = 1 - exp(-omega eps), which is t/t_r there; remaining life at the present stress and
/// temperature (1 - D)/(omega rate0) = 1/(omega f). rate0 and omega are functions of q and T, such as the polynomials
/// in log q of API 579-1/ASME FFS-1, Part 10. With OmegaCorrections::multiaxial, omega is replaced by
///   omega_m = max(omega - n, 3)^(1 + delta) + alpha n,   delta = beta ((sigma_1 + sigma_2 + sigma_3)/q - 1),
/// with n = d(log rate0)/d(log q), the exponent of Norton's law that has the same slope.
/// Source: M. Prager, J. Pressure Vessel Technol. 117 (1995), 95-103; API 579-1/ASME FFS-1 (2007), 10.3.5.3, F.7.1.1.

#include "law_table.hpp"
#include "scalar_state_law.hpp"
#include "stress_function.hpp"

namespace creepcontact::material {

/// What the standard adds to the constants of uniaxial tests.
struct OmegaCorrections {
  bool multiaxial = false;
  double alpha = 1, beta = 0.33;  ///< of the multiaxial correction
  double delta_sr = 0;            ///< scatter: rate0 is multiplied by 10^-delta_sr
  double delta_cd = 0;            ///< ductility: omega is multiplied by 10^delta_cd
};

class Omega final : public ScalarStateLaw<Omega, 1> {
 public:
  enum Constant {
    rate0,       ///< rate of the virgin material [1/time], of q and T, >= 0
    omega,       ///< [-], of q and T, > 0
    min_stress,  ///< below it rate0 is proportional to q, and omega constant; >= 0
    multiaxial,  ///< 1: OmegaCorrections::multiaxial
    alpha_omega,
    beta_omega,
    delta_sr,
    delta_cd,
    n_constants
  };
  /// @param values  by Constant, followed by those of ArrheniusConstant
  /// @throws ParameterError if the corrections are multiaxial and min_stress is 0: trace/q has no limit at q = 0
  explicit Omega(const ParameterValues& values);
  std::string name() const override { return "omega"; }
  bool uses_mean_stress() const override { return corrections_.multiaxial; }

  template <class Number>
  ScalarRates<Number, 1> rates(const ScalarStress<Number>& stress, const std::array<Number, 1>& eps,
                               const PointState& at) const {
    using std::exp;
    const Number virgin = rate_factor_ * at.parameters[activation] * rate0_(stress.q, at.temperature);
    const Number f = virgin * exp(effective_omega(stress, at.temperature) * eps[0]);
    return {f, {f}};
  }

  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  enum PointConstant { activation };  // evaluated at points: the factor of rate0

  /// omega, or omega_m. @param stress  q > 0
  template <class Number>
  Number effective_omega(const ScalarStress<Number>& stress, double temperature) const {
    using std::exp;
    using std::log;
    const Number uncorrected = omega_factor_ * omega_(stress.q, temperature);
    if (!corrections_.multiaxial) return uncorrected;
    const Number n = rate0_.exponent(stress.q, temperature);
    const Number difference = uncorrected - n;
    // Not std::max, which keeps a NaN or loses it by the order of its arguments.
    const Number uniaxial = difference < smallest_uniaxial ? Number(smallest_uniaxial + 0.0 * difference) : difference;
    const Number q = stress.q < rate0_.min_stress() ? Number(rate0_.min_stress() + 0.0 * stress.q) : stress.q;
    const Number delta = corrections_.beta * (stress.trace / q - 1.0);
    return exp((delta + 1.0) * log(uniaxial)) + corrections_.alpha * n;
  }

  static constexpr double smallest_uniaxial = 3;

  StressFunction rate0_, omega_;
  OmegaCorrections corrections_;
  double rate_factor_, omega_factor_;
};

LawInfo omega_info();

}  // namespace creepcontact::material
