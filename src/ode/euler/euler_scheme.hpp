#pragma once
/// What the two Euler schemes share: the step length, its control, the limit, retries, the last step kept for
/// interpolation.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "../step_clock.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "step_doubling.hpp"

namespace creepcontact::ode {

/// A scheme supplies advance(); this class decides where the step ends and what becomes of a failure.
class EulerScheme : public Integrator {
 public:
  /// @throws ConfigError for settings out of range
  EulerScheme(System& system, const IntegratorOptions& options) : EulerScheme(system, options, 0) {}

  /// One rate evaluation. The proposed step is used by adaptive steps alone.
  void initialize(double t, std::span<const double> y, double step = 0) override;
  StepReport step(double t_limit) final;

  bool interpolates() const final { return true; }
  /// y_n + theta (1 - theta) dt f_n + theta^2 (y_{n+1} - y_n): second order; linear for single explicit steps. Where
  /// that would leave the range between y_n and y_{n+1}, its bend is cut such that it just does not.
  void interpolate(double t, std::span<double> y) const final;

  double time() const final { return clock_.time(); }
  std::span<const double> state() const final { return current_.state; }
  double next_step() const final { return proposal_; }
  Counters counters() const final { return counters_; }

  bool restores_exactly() const final { return true; }
  RestartPoint save() const final;
  void restore(const RestartPoint& point) final;

 protected:
  /// @param residual_size  of EulerPoint::load_residual
  EulerScheme(System& system, const IntegratorOptions& options, std::size_t residual_size);

  /// One step of the scheme, a pure function of `from`: fills the state, and whatever of `to` falls out on the way.
  /// @throws RecoverableError if a smaller step may succeed, SolverError if the scheme gives up
  virtual void advance(const EulerPoint& from, const StepClock::Target& target, EulerPoint& to) = 0;
  /// Completes what the next step begins with.
  virtual void complete(double /*t*/, EulerPoint& /*to*/) {}
  virtual int order() const = 0;
  /// In stable steps: under error control longer ones are not worth a try. Infinity: all are.
  virtual double longest_adaptive_step() const = 0;
  /// In stable steps: with step = "stable" a larger step_factor is cut to it. Infinity: none is.
  virtual double longest_stable_step() const { return std::numeric_limits<double>::infinity(); }

  bool adaptive() const { return doubling_.has_value(); }
  /// A step that cannot be made: under error control a shorter one follows, else it is the end.
  [[noreturn]] void fail(const std::string& message) const;
  double stable_step() { return system_.stable_step(time(), current_.state); }

  System& system_;
  const IntegratorOptions options_;

 private:
  double wanted_step(double t_limit);
  double adaptive_step(double t_limit);
  /// Fills next_. @returns its error in units of the tolerance, 0 without error control
  double attempt(const StepClock::Target& target);
  [[noreturn]] void give_up(double shortest, const std::string& reason);
  /// The next adaptive step, after one of length `made` instead of `wanted`.
  void propose(double wanted, double made, double error, bool repeated);
  void accept(const StepClock::Target& target);
  /// At time(); infinity if nothing creeps. @throws SolverError if it is not positive
  double known_stable_step();
  bool needs_stable_step() const;
  /// Right after a step, where it often costs nothing and depends on nothing that is evaluated for outputs later.
  void foresee_stable_step();

  StepClock clock_;
  EulerPoint current_, next_;
  EulerPoint previous_;                   ///< at the beginning of the last step
  std::optional<StepDoubling> doubling_;  ///< adaptive steps
  double begin_ = 0;                      ///< of the last step
  double last_step_ = 0;
  double proposal_ = 0;
  std::optional<double> stable_;  ///< the stable step at time(), once known
  Counters counters_;
};

}  // namespace creepcontact::ode
