#pragma once
/// The default: a method that is watched while it runs, and changed where another one does better.

#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "creepcontact/ode/integrator.hpp"
#include "remaining_step_estimate.hpp"

namespace creepcontact::ode {

/// Begins with log_adams, which needs no Jacobian products and one evaluation per step; where creep hardly changes the
/// stress, with cvode_adams. Where the steps of either stay short though they exceed the stable one, so that stability
/// may be what limits them, cvode_bdf takes over as soon as the steps that lie ahead cost more than that would. Where
/// its iterations fail in many steps, or no step succeeds, it goes on with the tangent stiffness if the system offers
/// it. Every change is logged.
class AutoIntegrator final : public Integrator {
 public:
  AutoIntegrator(System& system, const IntegratorOptions& options);
  std::string name() const override { return "auto"; }
  std::string method() const override { return describe(method_); }

  void initialize(double t, std::span<const double> y, double step = 0) override;
  StepReport step(double t_limit) override;
  bool interpolates() const override { return true; }
  void interpolate(double t, std::span<double> y) const override { current_->interpolate(t, y); }

  double time() const override { return current_->time(); }
  std::span<const double> state() const override { return current_->state(); }
  double next_step() const override { return current_->next_step(); }
  Counters counters() const override;

  bool at_restart_point() const override { return current_->at_restart_point(); }
  RestartPoint save() const override;
  void restore(const RestartPoint& point) override;

 private:
  enum class Method { krylov = 0, tangent = 1, cvode_adams = 3, log_adams = 4 };  // numbers of checkpoints
  static bool is_functional(Method method) { return method == Method::cvode_adams || method == Method::log_adams; }

  std::unique_ptr<Integrator> make(Method method) const;
  static const char* describe(Method method);
  /// Between log_adams and cvode_adams, at the first breakpoint after which stress may relax before t_limit.
  void choose_functional(double t_limit);
  /// @param loads_since  time of the last breakpoint
  void begin_watch(double loads_since);
  void watch(const StepReport& report, double t_limit);
  /// The next step begins with this method.
  void change_later(Method method, std::string reason);
  void estimate_remaining_steps(double t_limit);
  /// The best of those not given up, or the present one if there is none.
  Method choose() const;
  /// @param has_failed  the present one, which is worth a warning
  void change_to(Method method, const std::string& reason, bool has_failed);
  /// Starts another method from the present state. @param step  see initialize()
  void go_on_with(Method method, double step);

  struct Observation {
    std::int64_t failures, products;  ///< counters after the step
    double error;                     ///< estimate for the step
  };
  System& system_;
  const IntegratorOptions options_;
  Method method_;
  bool chosen_ = false;    ///< between log_adams and cvode_adams
  bool starting_ = false;  ///< at a breakpoint
  std::set<Method> given_up_;
  std::unique_ptr<Integrator> current_;
  std::deque<Observation> recent_;  ///< the last steps, the oldest first
  double last_step_ = 0;
  std::size_t steps_with_method_ = 0;
  RemainingStepEstimate remaining_step_estimate_;
  double last_estimate_ = 0;
  bool trouble_ = false;          ///< seen at the end of the last step
  std::optional<Method> wanted_;  ///< instead of the present one, if not that of choose()
  std::string reason_;
  std::string failure_;  ///< of the first method that made no step from here
  Counters before_;      ///< of the integrators before the present one
  static constexpr auto saved_members =
      std::tuple{Member{"method", &AutoIntegrator::method_}, Member{"chosen", &AutoIntegrator::chosen_},
                 Member{"starting", &AutoIntegrator::starting_}};
};

}  // namespace creepcontact::ode
