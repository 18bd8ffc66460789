#pragma once
/// Booker's law of 2.25Cr-1Mo steel (ASME III-5 HBB): two creep curves, and a change from the first to the second. At
/// constant stress and temperature curve i is
///   e_i(t) = limit_i speed_i t/(1 + speed_i t) + rate_i t,
/// and the strain is the smaller of e_1(t) and e_2(t) up to the time `change`, from then on e_2, shifted in time so
/// that the strain is continuous. The functions of q, T and U = strength(T) are in the file of the material. Where the
/// stress changes it hardens by strain: states are the accumulated strain eps and x, the part of the change that is
/// used up, dx/dt = 1/change. With t_i(eps) the time at which curve i reaches eps,
///   f = de_i/dt at t_i, of curve 1 if t_1 >= t_2 and x < 1, of curve 2 else.
/// Both switches of f are gradual over 0.2 %, of the ratio of the t_i and of x, so that f is continuous.
/// With w = 1/(1 + speed_i t_i), which solves a quadratic equation, f = speed limit w^2 + rate and
/// eps/t_i = speed limit w + rate: the curve with the smaller eps/t_i has the larger t_i, at eps = 0 too.
/// Source: M. K. Booker, ORNL; the equations in hbbdata (Argonne), isochronous.py, Model225Cr.

#include "law_table.hpp"
#include "scalar_state_law.hpp"
#include "stress_function.hpp"

namespace creepcontact::material {

class Booker final : public ScalarStateLaw<Booker, 2> {
 public:
  enum Constant {
    strength,  ///< U [stress], of T, > 0
    limit_1,   ///< [-], of q, T, U, >= 0; the others likewise
    speed_1,   ///< [1/time]
    rate_1,    ///< [1/time]
    limit_2,
    speed_2,
    rate_2,
    change,           ///< [time], > 0
    min_temperature,  ///< no creep up to here; empty: none
    n_constants
  };
  explicit Booker(const ParameterValues& values);
  std::string name() const override { return "booker"; }
  InternalKind internal_kind(int variable) const override {
    return variable == 0 ? InternalKind::strain : InternalKind::fraction;
  }

  template <class Number>
  ScalarRates<Number, 2> rates(const ScalarStress<Number>& stress, const std::array<Number, 2>& state,
                               const PointState& at) const {
    if (at.temperature <= min_temperature_) return {0.0 * stress.q, {0.0 * stress.q, 0.0 * stress.q}};
    const Number changing = changes_(stress.q, at.temperature, at.parameters[0]);
    const Curve<Number> second = curve(curves_[1], stress.q, state[0], at);
    const Number changed = step(state[1]);
    if (changed == 1.0) return {second.rate, {second.rate, changing}};
    const Curve<Number> first = curve(curves_[0], stress.q, state[0], at);
    if (first.mean_rate >= (1.0 + half_width) * second.mean_rate) return {second.rate, {second.rate, changing}};
    Number lower = first.rate;  // of the lower curve
    if (first.mean_rate > (1.0 - half_width) * second.mean_rate) {
      // It goes over from one to the other along eps: the times per strain are averaged.
      const Number part = step(Number(first.mean_rate / second.mean_rate));
      lower = first.rate * second.rate / ((1.0 - part) * second.rate + part * first.rate);
    }
    const Number f = lower + changed * (second.rate - lower);
    return {f, {f, changing}};
  }

  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  static constexpr double half_width = 0.001;
  /// Rises smoothly from 0 to 1 where x is about 1.
  template <class Number>
  static Number step(const Number& x) {
    const Number s = (x - (1.0 - half_width)) / (2.0 * half_width);
    if (s <= 0.0) return Number(0.0 * x);
    if (s >= 1.0) return Number(1.0 + 0.0 * x);
    return s * s * (3.0 - 2.0 * s);
  }

  struct CurveFunctions {
    StressFunction limit, speed, rate;
  };
  template <class Number>
  struct Curve {
    Number rate;       ///< de_i/dt where the strain is eps
    Number mean_rate;  ///< eps/t_i
  };

  template <class Number>
  static Curve<Number> curve(const CurveFunctions& of, const Number& q, const Number& eps, const PointState& at) {
    using std::sqrt;
    const double T = at.temperature, U = at.parameters[0];
    const Number limit = of.limit(q, T, U), speed = of.speed(q, T, U), rate = of.rate(q, T, U);
    constexpr double negligible = 1e-150;  // its square does not vanish
    if (limit < negligible || speed < negligible) return {rate, rate};
    // w: limit w^2 + (eps - limit + steady) w - steady = 0, from the side that loses no digits
    const Number steady = rate / speed;  // strain in the time 1/speed
    const Number g = limit - steady - eps;
    const Number radicand = g * g + 4.0 * limit * steady;
    Number w = 0.0 * q;
    if (radicand > 0.0) {
      const Number root = sqrt(radicand);
      if (g > 0.0)
        w = (g + root) / (2.0 * limit);
      else
        w = 2.0 * steady / (root - g);
    }
    const Number primary = speed * limit * w;
    return {primary * w + rate, primary + rate};
  }

  std::array<CurveFunctions, 2> curves_;
  StressFunction changes_;  // 1/change
  double min_temperature_;
};

LawInfo booker_info();

}  // namespace creepcontact::material
