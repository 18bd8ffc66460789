#pragma once
/// Blackburn's law of austenitic steels (isochronous curves of ASME III-5 HBB): at constant stress and temperature
///   strain_unit (ex (1 - exp(-s t)) + et (1 - exp(-r t)) + em t),   sigma = q/stress_unit,
///   g(beta, n) = sinh(beta sigma/n)^n exp(-Q/(R (T - absolute_zero))),
///   em = A g(beta, n),   s = max(D g(beta_r, n_r), s_min),   r = max(B g(beta_r, n_r), L sigma^(n - l)),
///   et = C em/r,   ex = max(G + H sigma, 0) from the threshold on, 0 below.
/// The strains of both transients are states of their own, d e_x/dt = s max(ex - e_x, 0), the same for e_t, as in
/// Soderberg's law: after a rise of the stress there is more transient creep, after a fall none; nothing recovers.
/// Source: L. D. Blackburn, in: The Generation of Isochronous Stress-Strain Curves, ASME (1972), 15-48.

#include "law_table.hpp"
#include "scalar_state_law.hpp"

namespace creepcontact::material {

class Blackburn final : public ScalarStateLaw<Blackburn, 2> {
 public:
  /// A, B and D have the factor exp(-Q/(R T)) of thermal activation.
  enum Constant {
    A,          ///< [strain_unit/time], >= 0
    beta,       ///< [1/stress_unit], > 0
    n,          ///< [-], >= 1
    B,          ///< [1/time], > 0
    C,          ///< [-], >= 0
    D,          ///< [1/time], >= 0
    G,          ///< [strain_unit]
    H,          ///< [strain_unit/stress_unit]
    L,          ///< [1/time], >= 0
    beta_r,     ///< [1/stress_unit], > 0; empty: beta
    n_r,        ///< [-], >= 1; empty: n
    s_min,      ///< [1/time], >= 0. From here on numbers, which are not evaluated at points
    l,          ///< [-]
    threshold,  ///< [stress_unit], >= 0
    stress_unit,
    strain_unit,
    n_constants
  };
  explicit Blackburn(const ParameterValues& values);
  std::string name() const override { return "blackburn"; }

  template <class Number>
  ScalarRates<Number, 2> rates(const ScalarStress<Number>& stress, const std::array<Number, 2>& strain,
                               const PointState& at) const {
    const Terms<Number> of = terms(stress.q, at.parameters);
    Number fast = of.fast * (of.fast_limit - strain[0]);
    if (fast < 0.0) fast = 0.0 * stress.q;
    Number slow = of.slow_start - of.slow * strain[1];
    if (slow < 0.0) slow = 0.0 * stress.q;
    return {fast + slow + of.steady, {fast, slow}};
  }

  void increment(const PointState& at, double duration, PointIncrement into) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  /// Strains as numbers, not in strain_unit.
  template <class Number>
  struct Terms {
    Number fast, fast_limit;  ///< s, ex
    Number slow, slow_start;  ///< r, r et = C em: finite where both r and em vanish
    Number steady;            ///< em
  };

  template <class Number>
  Terms<Number> terms(const Number& q, std::span<const double> of) const {
    using std::exp;
    using std::log;
    using std::sinh;
    const Number sigma = q / stress_unit_;
    const Number flow = power(Number(sinh(of[beta] / of[n] * sigma)), of[n]);
    const Number transient = own_transient_ ? power(Number(sinh(of[beta_r] / of[n_r] * sigma)), of[n_r]) : flow;
    Terms<Number> terms;
    terms.steady = strain_unit_ * of[A] * flow;
    terms.fast = of[D] * transient;
    if (terms.fast < s_min_) terms.fast = s_min_ + 0.0 * sigma;
    terms.fast_limit = strain_unit_ * (of[G] + of[H] * sigma);
    if (sigma < threshold_ || terms.fast_limit < 0.0) terms.fast_limit = 0.0 * sigma;
    terms.slow = of[B] * transient;
    if (of[L] > 0.0) {
      const Number least = of[L] * exp((of[n] - l_) * log(sigma));
      if (terms.slow < least) terms.slow = least;
    }
    terms.slow_start = of[C] * terms.steady;
    return terms;
  }

  bool own_transient_;  // beta_r or n_r differ from beta, n
  double s_min_, l_, threshold_, stress_unit_, strain_unit_;
};

LawInfo blackburn_info();

}  // namespace creepcontact::material
