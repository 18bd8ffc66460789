#pragma once
/// Laws with scalar internal variables z: rate = 3/2 (f/q) s, dz/dt = g. Here f and g are functions of the equivalent
/// stress q, of the trace of the stress if the law wants it, of z, of the time and of the temperature. A law writes its
/// formulas once, as a template in the type of number; the derivatives are those of automatic differentiation, exact up
/// to rounding.

#include <Eigen/Core>
#include <array>
#include <unsupported/Eigen/AutoDiff>

#include "coaxial.hpp"
#include "power.hpp"

namespace creepcontact::material {

/// @param exponent  >= 1
template <class Derivatives>
Eigen::AutoDiffScalar<Derivatives> power(const Eigen::AutoDiffScalar<Derivatives>& base, double exponent) {
  const double below = power(base.value(), exponent - 1.0);
  return {below * base.value(), exponent * below * base.derivatives()};
}

template <class Number, std::size_t n>
struct ScalarRates {
  Number strain;                   ///< f [1/time]
  std::array<Number, n> internal;  ///< g
};

/// What such a law sees of the stress.
template <class Number>
struct ScalarStress {
  Number q;      ///< von Mises stress, > 0
  Number trace;  ///< sigma_1 + sigma_2 + sigma_3
};

/// @tparam Law  derived from this class. It has, for double and for Dual,
///   template <class Number>
///   ScalarRates<Number, n> rates(const ScalarStress<Number>& stress, const std::array<Number, n>& z,
///                                const PointState& at) const;
/// It is called with q > 0 (without stress all rates are zero). It reads parameters, time and temperature of `at`, but
/// not its stress and internal variables.
/// @tparam n  number of internal variables
template <class Law, std::size_t n>
class ScalarStateLaw : public CreepLaw {
 public:
  /// Derivatives with respect to q, to z, and to the trace of the stress.
  using Derivatives = Eigen::Matrix<double, static_cast<int>(n) + 2, 1>;
  using Dual = Eigen::AutoDiffScalar<Derivatives>;

  int n_internal() const final { return static_cast<int>(n); }

  void rate(const PointState& at, PointRate into) const final {
    const Deviator now = deviator(at.stress);
    if (now.q == 0.0) {
      std::ranges::fill(into.internal, 0.0);
      return;
    }
    const ScalarStress<double> stress{now.q, tensor::trace(at.stress)};
    const auto rates = law().rates(stress, internal_of(at), at);
    add_flow(now, rates.strain, into.creep_strain);
    std::ranges::copy(rates.internal, into.internal.begin());
  }

  void derivative(const PointState& at, const PointChange& change, PointRate into) const final {
    const Deviator now = deviator(at.stress);
    const auto rates = linearized(now, at);
    const Tensor6 ds = tensor::deviator(change.stress);
    add_tangent(now, tangent(now, rates.strain), ds, into.creep_strain);
    if (now.q == 0.0) {
      std::ranges::fill(into.internal, 0.0);
      return;
    }
    Derivatives changes;
    changes[0] = 1.5 * now.s.dot(ds) / now.q;
    for (std::size_t i = 0; i < n; ++i) changes[i + 1] = change.internal[i];
    changes[n + 1] = tensor::trace(change.stress);
    constexpr int others = static_cast<int>(n) + 1;  // than q
    add_flow(now, rates.strain.derivatives().template tail<others>().dot(changes.template tail<others>()),
             into.creep_strain);
    for (std::size_t i = 0; i < n; ++i) into.internal[i] = rates.internal[i].derivatives().dot(changes);
  }

  /// Without the change of the rate with the trace, for which StressTangent has no place.
  StressTangent stress_tangent(const PointState& at) const final {
    const Deviator now = deviator(at.stress);
    return tangent(now, linearized(now, at).strain);
  }

 protected:
  using CreepLaw::CreepLaw;

  static std::array<double, n> internal_of(const PointState& at) {
    std::array<double, n> z;
    std::copy_n(at.internal.begin(), n, z.begin());
    return z;
  }

 private:
  const Law& law() const { return static_cast<const Law&>(*this); }

  ScalarRates<Dual, n> linearized(const Deviator& now, const PointState& at) const {
    constexpr int unknowns = static_cast<int>(n) + 2;
    const ScalarStress<Dual> stress{Dual(now.q > 0.0 ? now.q : vanishing_stress, unknowns, 0),
                                    Dual(tensor::trace(at.stress), unknowns, unknowns - 1)};
    std::array<Dual, n> z;
    for (std::size_t i = 0; i < n; ++i) z[i] = Dual(at.internal[i], unknowns, static_cast<int>(i) + 1);
    return law().rates(stress, z, at);
  }

  static StressTangent tangent(const Deviator& now, const Dual& f) {
    const double slope = f.derivatives()[0];
    // Functions of the stress may have no limit at zero stress, where nothing creeps.
    return coaxial_tangent(now.q, f.value(), now.q == 0.0 && !std::isfinite(slope) ? 0.0 : slope);
  }
};

}  // namespace creepcontact::material
