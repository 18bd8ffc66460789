#pragma once
/// Soderberg's law: at constant stress the creep strain C q^p (1 - exp(-r t)) + A q^n t. The primary strain eps_p is a
/// state of its own, d eps_p/dt = r max(C q^p - eps_p, 0). After a rise of the stress there is more primary creep,
/// after a fall none until the steady part is all that is left; nothing recovers. f = d eps_p/dt + A q^n.
/// Source: C. R. Soderberg, Trans. ASME 58 (1936); primary creep that ends exponentially: P. G. McVetty (1934).

#include "law_table.hpp"
#include "scalar_state_law.hpp"

namespace creepcontact::material {

class Soderberg final : public ScalarStateLaw<Soderberg, 1> {
 public:
  enum Constant {
    C,  ///< [1/stress^p], >= 0
    p,  ///< [-], >= 1
    r,  ///< [1/time], > 0
    A,  ///< [1/(time stress^n)], >= 0
    n,  ///< [-], >= 1
    n_constants
  };
  explicit Soderberg(const ParameterValues& values) : ScalarStateLaw(first(values, n_constants)) {}
  std::string name() const override { return "soderberg"; }

  template <class Number>
  ScalarRates<Number, 1> rates(const ScalarStress<Number>& stress, const std::array<Number, 1>& primary,
                               const PointState& at) const {
    const Number& q = stress.q;
    const auto& of = at.parameters;
    Number growth = of[r] * (of[C] * power(q, of[p]) - primary[0]);
    if (growth < 0.0) growth = 0.0 * q;
    return {growth + of[A] * power(q, of[n]), {growth}};
  }

  void increment(const PointState& at, double duration, PointIncrement into) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;
};

LawInfo soderberg_info();

}  // namespace creepcontact::material
