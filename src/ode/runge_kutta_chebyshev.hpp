#pragma once
/// Stabilised explicit Runge-Kutta-Chebyshev method of order 2 with error control.
/// Source: Sommeijer, Shampine, Verwer (1997), RKC: an explicit solver for parabolic PDEs.

#include <vector>

#include "chebyshev_stages.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "error_norm.hpp"
#include "step_clock.hpp"

namespace creepcontact::ode {

/// s stages are stable for steps of 0.653 (s^2 - 1) / radius, the radius being that of the spectrum, which is real and
/// negative: the cost of a step grows with the square root of its length, where explicit methods without
/// stabilisation pay for the length itself. Needs no Jacobian and no linear solve.
/// The radius is 2 / System::stable_step: the relaxation rate of the stiffest point bounds that of the whole system,
/// held together by equilibrium and with the set of closed contacts held fixed or not.
/// Cost: s rate evaluations per step; memory: 8 vectors with the weights, whatever s.
class RungeKuttaChebyshev final : public Integrator {
 public:
  /// @throws ConfigError if the tolerance is not positive
  RungeKuttaChebyshev(System& system, const IntegratorOptions& options);
  std::string name() const override { return "rkc2"; }

  /// One rate evaluation, and one more in the first step() if step = 0.
  void initialize(double t, std::span<const double> y, double step = 0) override;
  StepReport step(double t_limit) override;

  bool interpolates() const override { return true; }
  /// Cubic Hermite polynomial of both ends of the step.
  void interpolate(double t, std::span<double> y) const override;

  double time() const override { return clock_.time(); }
  std::span<const double> state() const override { return state_; }
  double next_step() const override { return proposal_; }
  Counters counters() const override { return counters_; }

  bool restores_exactly() const override { return true; }
  RestartPoint save() const override;
  void restore(const RestartPoint& point) override;

 private:
  double first_step(double t_limit);
  /// All stages into newer_, its rate into stage_rate_. @throws RecoverableError
  void run_stages(const StepClock::Target& target);
  double local_error(double h) const;
  double radius(double t, std::span<const double> y);
  void accept(const StepClock::Target& target);
  double next_step_after(double h, double error, bool repeated);

  System& system_;
  const IntegratorOptions options_;
  ErrorNorm norm_;
  StepClock clock_;
  std::vector<double> state_, rate_;              ///< y_n and f_n
  std::vector<double> newer_, older_;             ///< Y_j and Y_{j-1}
  std::vector<double> stage_rate_;                ///< F_j
  std::vector<double> previous_, previous_rate_;  ///< at the beginning of the last step
  std::vector<ChebyshevStage> stages_;            ///< of the last number of stages
  double radius_ = 0;                             ///< of the spectrum at y_n, at most
  double begin_ = 0, last_step_ = 0;
  double proposal_ = 0;
  double controlled_step_ = 0, controlled_error_ = 0;  ///< of the last step that no limit cut; 0: none yet
  Counters counters_;
  static constexpr auto saved_members = std::tuple{Member{"radius", &RungeKuttaChebyshev::radius_},
                                                   Member{"controlled_step", &RungeKuttaChebyshev::controlled_step_},
                                                   Member{"controlled_error", &RungeKuttaChebyshev::controlled_error_}};
};

}  // namespace creepcontact::ode
