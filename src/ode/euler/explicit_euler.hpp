#pragma once
/// Explicit Euler: y_{n+1} = y_n + dt f(t_n, y_n). Source: Stankevich (2012), explicit scheme.

#include "euler_scheme.hpp"

namespace creepcontact::ode {

/// Cost: one rate evaluation per step (two, one per half, if adaptive), made at the new state before it is accepted, so
/// that a failure there can be answered by a smaller step and accept() meets the point of the last evaluation.
/// residual_correction is without effect: the load of every evaluation is the state itself, so that the residual of
/// nodal forces, which the article's incremental form carries along, is zero here by construction.
class ExplicitEuler final : public EulerScheme {
 public:
  using EulerScheme::EulerScheme;
  std::string name() const override { return "explicit_euler"; }
  void initialize(double t, std::span<const double> y, double step = 0) override;

 protected:
  void advance(const EulerPoint& from, const StepClock::Target& target, EulerPoint& to) override;
  void complete(double t, EulerPoint& to) override;
  int order() const override { return 1; }
  /// Either half is a stable step: beyond that the error estimate would reject most of them.
  double longest_adaptive_step() const override { return 2 * margin; }

 private:
  /// Steps that are little too long only make the solution oscillate: it would end as if nothing were wrong.
  void warn_if_unstable(double t, std::span<const double> y);

  static constexpr double margin = 0.9;
  double made_ = 0;  ///< length of the step
  bool warned_ = false;
};

}  // namespace creepcontact::ode
