#pragma once
/// Explicit Euler: y_{n+1} = y_n + dt f(t_n, y_n). Source: Stankevich (2012), explicit scheme.

#include "euler_scheme.hpp"

namespace creepcontact::ode {

/// Cost: one rate evaluation a step, made at the new state before it is accepted, so that a failure there can be
/// answered by a smaller step and accept() meets the point of the last evaluation.
/// residual_correction is without effect: the load of every evaluation is the state itself, so that the residual of
/// nodal forces, which the article's incremental form carries along, is zero here by construction.
class ExplicitEuler final : public EulerScheme {
 public:
  using EulerScheme::EulerScheme;
  std::string name() const override { return "explicit_euler"; }

 protected:
  void attempt(const StepClock::Target& target) override;
  int order() const override { return 1; }
};

}  // namespace creepcontact::ode
