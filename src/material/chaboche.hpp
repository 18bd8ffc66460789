#pragma once
/// Unified viscoplasticity: creep and rate-dependent plasticity as one inelastic strain, with kinematic and isotropic
/// hardening. With xi = s - X, J(xi) = sqrt(3/2 xi:xi) and the overstress F = J(xi) - yield - R:
///   dp/dt = (F/K)^n, or sinh_rate sinh(F/K)^n; 0 for F <= 0.
///   d eps/dt = 3/2 dp/dt xi/J(xi)
///   X = sum of X_i,  dX_i/dt = 2/3 C_i d eps/dt - gamma_i X_i dp/dt - r_i J(X_i)^(m_i-1) X_i,  X_i(0) = 0.
///   dR/dt = b (Q - R) dp/dt,  R(0) = 0.
/// Internal variables: the tensors alpha_i with X_i = 2/3 C_i alpha_i, p, and R/Q if Q is not 0. So X_i and R follow C
/// and Q where the temperature changes.
/// Sources: J.-L. Chaboche, Int. J. Plasticity 5 (1989) and 24 (2008); P. J. Armstrong, C. O. Frederick (1966).

#include "creepcontact/base/index.hpp"
#include "creepcontact/material/creep_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class Chaboche final : public CreepLaw {
 public:
  enum Constant {
    K,                  ///< [stress time^(1/n)]; with sinh_rate [stress], > 0
    n,                  ///< [-], >= 1
    yield,              ///< [stress], >= 0
    Q,                  ///< [stress]; yield + Q >= 0
    b,                  ///< [-], >= 0
    C,                  ///< list [stress], >= 0
    gamma,              ///< list [-], >= 0
    recovery,           ///< list r_i [1/(time stress^(m_i-1))], >= 0; or empty
    recovery_exponent,  ///< list m_i [-], >= 1; empty: 1
    sinh_rate,          ///< [1/time], >= 0; 0: the power law
    n_constants
  };
  /// @throws ParameterError if the lists differ in length, or if constant yield and Q leave no elastic range
  explicit Chaboche(const ParameterValues& values);
  std::string name() const override { return "chaboche"; }
  int n_internal() const override { return static_cast<int>(6 * n_back_stresses_) + 1 + (hardens_ ? 1 : 0); }
  InternalKind internal_kind(int variable) const override {
    return variable == 6 * n_back_stresses_ + 1 ? InternalKind::fraction : InternalKind::strain;
  }
  bool yields() const override { return true; }
  bool is_coaxial() const override { return n_back_stresses_ == 0; }

  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& at) const override;
  /// One implicit Euler step: bounded by hardening, where the rate times the duration is not.
  void increment(const PointState& at, double duration, PointIncrement into) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  /// The values of the constants at a point.
  struct Values;
  /// The state of the flow at a point.
  struct Flow;
  /// dp/dt and its derivative with respect to the overstress.
  struct Rate {
    double value = 0, slope = 0;
  };
  static Rate flow_rate(const Values& of, double overstress);
  Values values(const PointState& at) const;
  Flow flow(const Values& of, const PointState& at) const;
  Tensor6 back_stress(const Values& of, std::span<const double> internal) const;
  std::size_t p_index() const { return 6 * n_back_stresses_; }

  Index n_back_stresses_;
  bool recovers_, hardens_;
};

LawInfo chaboche_info();

}  // namespace creepcontact::material
