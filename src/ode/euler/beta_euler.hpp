#pragma once
/// Implicit Euler with parameter beta (generalised trapezoidal rule), solved by fixed-point iterations, plain ones as
/// in the article or accelerated ones, or by Newton's:
///   y_{n+1} = y_n + dt [(1 - beta) f(t_n, y_n) + beta f(t_{n+1}, y_{n+1})].
/// Source: Stankevich (2012), implicit scheme.

#include <memory>

#include "convergence_watch.hpp"
#include "creepcontact/ode/anderson_iteration.hpp"
#include "euler_scheme.hpp"
#include "newton_iteration.hpp"
#include "residual_correction.hpp"

namespace creepcontact::ode {

/// Order 2 for beta = 1/2, else 1. Cost: one rate evaluation per inner iteration; the last one of a step serves as
/// f(t_n, y_n) of the next. Plain iterations contract only for beta dt |lambda| < 1, lambda the fastest relaxation of
/// the system, that is for dt < (stable step of explicit Euler) / (2 beta); accelerated ones go some times as far, and
/// Newton's, each of which also takes Jacobian products, have no bound.
class BetaEuler final : public EulerScheme {
 public:
  /// @throws ConfigError for beta < 0.5 (not stable) or > 1, and for settings out of range
  BetaEuler(System& system, const IntegratorOptions& options);
  std::string name() const override { return "beta_euler"; }

 protected:
  void advance(const EulerPoint& from, const StepClock::Target& target, EulerPoint& to) override;
  int order() const override { return options_.beta == 0.5 ? 2 : 1; }
  double longest_adaptive_step() const override;
  double longest_stable_step() const override;

 private:
  /// image = y_n + dt [(1 - beta) f(t_n, y_n) + beta f(t_{n+1}, e)], e the load strain of y
  void map(std::span<const double> y, std::span<double> image);
  void iterate_plainly(std::vector<double>& y, ConvergenceWatch& watch);
  void iterate_by_newton(EulerPoint& to, ConvergenceWatch& watch);
  bool good_guess(std::span<const double> y);
  /// In stable steps of explicit Euler.
  double step_that_contracts_by(double factor) const;
  [[noreturn]] void give_up(const ConvergenceWatch& watch);

  const EulerPoint* from_ = nullptr;  ///< of the step under way
  StepClock::Target target_;
  ResidualCorrection residual_correction_;
  std::vector<double> load_;                     ///< e^(k), the argument of the last rate evaluation
  std::vector<double> load_rate_;                ///< its rate
  std::vector<double> iterate_;                  ///< y^(k+1) under construction
  std::unique_ptr<AndersonIteration> anderson_;  ///< none: plain iterations, or ...
  std::unique_ptr<NewtonIteration> newton_;
};

}  // namespace creepcontact::ode
