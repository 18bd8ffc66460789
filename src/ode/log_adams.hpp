#pragma once
/// Linearly implicit Adams method in logarithmic time: one rate evaluation per step.
/// Sources: Shampine, Gordon (1975), Computer solution of ordinary differential equations: the variable order and step;
/// Steihaug, Wolfbrandt (1979): methods of full order with an approximate Jacobian.

#include <string>
#include <vector>

#include "creepcontact/ode/integrator.hpp"
#include "error_norm.hpp"
#include "log_adams_history.hpp"
#include "step_clock.hpp"

namespace creepcontact::ode {

/// Three ideas make the steps few and cheap:
/// - Relaxing stress is a smooth function of the logarithm of time. (t + unit)^power times the rate is interpolated by
///   a polynomial in s = log(1 + t/unit), and integrated exactly. power 0 suits steady creep, and 1 to 1.25 relaxation;
///   it follows the smaller error estimate.
/// - The corrector takes the rate at the predicted state only. Its change is damped by the preconditioner of the system
///   (I - gamma J_local)^-1, which costs no evaluation: (f(y) - f(p)) is taken as J_local (y - p).
/// - Since J_local is at least as stiff as J, that is stable far beyond the stable step of explicit Euler: with order 1
///   for any J between 0 and J_local, with order 2 from 0.65 to 0.95 of J_local on, or up to 3 stable steps.
/// A system without JacobianProducts gets the undamped corrector. Cost: one rate evaluation per step, accepted or not;
/// memory: 10 vectors with the weights.
class LogAdams final : public Integrator {
 public:
  /// @throws ConfigError if the tolerance is not positive
  LogAdams(System& system, const IntegratorOptions& options);
  std::string name() const override { return "log_adams"; }

  /// One rate evaluation, and one more in the first step() if step = 0.
  void initialize(double t, std::span<const double> y, double step = 0) override;
  StepReport step(double t_limit) override;

  bool interpolates() const override { return true; }
  void interpolate(double t, std::span<double> y) const override;

  double time() const override { return clock_.time(); }
  std::span<const double> state() const override { return state_; }
  double next_step() const override { return proposal_; }
  Counters counters() const override { return counters_; }

  bool restores_exactly() const override { return true; }
  RestartPoint save() const override;
  void restore(const RestartPoint& point) override;

 private:
  using Row = LogAdamsHistory::Row;
  /// Errors of the present step, in units of those allowed; those of other orders and powers are of the same step.
  struct Errors {
    double own = 0;
    double lower = 0, higher = 0;  ///< 0: unknown
  };
  void begin(double t_limit);
  /// y = the state plus these multiples of phi_.
  void add_integral(const Row& integrals, std::span<double> y) const;
  /// The error that a step would have, relative to the allowed one; infinite if there is no rate at its end.
  double error_of(const StepClock::Target& target);
  void slide(const StepClock::Target& target);
  void predict(double s);
  /// The change of the rate at the predicted state against the extrapolated one, damped. @throws RecoverableError
  void correct(const StepClock::Target& target, double s);
  Errors errors() const;
  double norm_of(const std::vector<double>& rate) const;
  /// Norm of the change of the rate plus factor * term.
  double norm_with(double factor, const std::vector<double>& term) const;
  void accept(const StepClock::Target& target, double s);
  /// Goes to next_state_.
  void finish(const StepClock::Target& target);
  void follow_power(Errors& errors);
  void transform(const LogAdamsHistory::Matrix& matrix);
  /// Chooses the next order. @returns the factor by which the step may change
  double choose_order(const Errors& errors);
  double order_of_cut_step(const Errors& errors);
  /// @param growth  of the step
  bool is_stable(int order, double growth) const;
  double shortened(double h, const Errors& errors);

  System& system_;
  const IntegratorOptions options_;
  ErrorNorm norm_;
  StepClock clock_;
  LogAdamsHistory history_;
  std::vector<double> state_, next_state_;
  std::vector<double> extrapolated_;      ///< rate that the polynomial predicts
  std::vector<double> change_, work_;     ///< of the rate
  std::vector<std::vector<double>> phi_;  ///< of history_
  Row stretch_{}, integrals_{};           ///< of the present step
  int order_ = 1;
  bool climbing_ = true;     ///< in the starting phase, in which every step raises the order
  double stable_ = 0;        ///< stable step, of a few steps ago at most
  int stable_age_ = 0;       ///< in steps
  double stiffness_ = 0;     ///< of the last step: its length in half stable steps
  int power_direction_ = 1;  ///< in which another power is tried next
  double begin_ = 0, last_step_ = 0;
  double proposal_ = 0;
  Counters counters_;
  static constexpr auto saved_members =
      std::tuple{Member{"history", &LogAdams::history_},       Member{"order", &LogAdams::order_},
                 Member{"climbing", &LogAdams::climbing_},     Member{"stable", &LogAdams::stable_},
                 Member{"stable_age", &LogAdams::stable_age_}, Member{"power_direction", &LogAdams::power_direction_},
                 Member{"last_step", &LogAdams::last_step_}};
};

}  // namespace creepcontact::ode
