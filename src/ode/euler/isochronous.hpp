#pragma once
/// Ageing theory: no rate is integrated, the state is a function of the current stress and time.

#include <string>
#include <vector>

#include "creepcontact/ode/integrator.hpp"
#include "newton_iteration.hpp"

namespace creepcontact::ode {

/// Solves y = f(t, y) for every limit it is given, System::rate() being the function f. Newton's method begins with the
/// last state; where it fails, states in between lead there.
class Isochronous final : public Integrator {
 public:
  Isochronous(System& system, const IntegratorOptions& options);

  std::string name() const override { return "isochronous"; }
  /// @param y  first guess of the state
  void initialize(double t, std::span<const double> y, double step = 0) override;
  bool jumps_with_loads() const override { return true; }
  /// Ends at t_limit, or before it if only a shorter way can be solved.
  StepReport step(double t_limit) override;
  void interpolate(double t, std::span<double> y) const override;
  double time() const override { return time_; }
  std::span<const double> state() const override { return state_; }
  double next_step() const override { return 0; }
  Counters counters() const override { return counters_; }

 private:
  /// state_ at t from the guess in next_. @throws RecoverableError
  void solve(double t);

  System& system_;
  double tolerance_;
  NewtonIteration newton_;
  double time_ = 0;
  std::vector<double> state_, next_, image_, rate_, point_;
  Counters counters_;
};

}  // namespace creepcontact::ode
