#pragma once
/// What the two Euler schemes share: the step length, the limit, retries, the last step kept for interpolation.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/ode/integrator.hpp"
#include "step_clock.hpp"

namespace creepcontact::ode {

/// A scheme supplies attempt(); this class decides where the step ends and what becomes of a failure.
class EulerScheme : public Integrator {
 public:
  EulerScheme(System& system, const IntegratorOptions& options);

  /// One rate evaluation. The proposed step is not used: the options say how long the steps are.
  void initialize(double t, std::span<const double> y, double step = 0) override;
  StepReport step(double t_limit) final;

  bool interpolates() const final { return true; }
  /// y_n + theta (1 - theta) dt f_n + theta^2 (y_{n+1} - y_n): second order, linear for the explicit scheme.
  void interpolate(double t, std::span<double> y) const final;

  double time() const final { return clock_.time(); }
  std::span<const double> state() const final { return state_; }
  double next_step() const final { return proposal_; }
  Counters counters() const final { return counters_; }

  bool restores_exactly() const final { return true; }
  RestartPoint save() const override;
  void restore(const RestartPoint& point) override;

 protected:
  /// Fills candidate_ with the state at target.time and candidate_rate_ with a rate there.
  /// @throws RecoverableError if a smaller step may succeed, SolverError if the scheme gives up
  virtual void attempt(const StepClock::Target& target) = 0;
  virtual int order() const = 0;
  /// The scheme keeps what it needs of the accepted step; state_ and candidate_ are still the old and the new state.
  virtual void accepted() {}

  double stable_step() { return system_.stable_step(time(), state_); }

  System& system_;
  const IntegratorOptions options_;
  std::vector<double> state_, rate_;                ///< y_n and f_n
  std::vector<double> candidate_, candidate_rate_;  ///< y_{n+1} and f_{n+1}

 private:
  double wanted_step(double t_limit);
  /// Right after a step, where it often costs nothing and depends on nothing that is evaluated for outputs later.
  void foresee_stable_step();

  StepClock clock_;
  std::vector<double> previous_, previous_rate_;  ///< at the beginning of the last step
  double begin_ = 0;                              ///< of the last step
  double last_step_ = 0;
  double proposal_ = 0;
  std::optional<double> stable_;  ///< the stable step at time(), once known
  Counters counters_;
};

}  // namespace creepcontact::ode
