#pragma once
/// Integration from points where the rate is infinite: creep strain that grows as (t - t0)^m, m < 1, from t0 on.

#include <memory>
#include <string>
#include <vector>

#include "creepcontact/ode/integrator.hpp"
#include "time_transformed_system.hpp"

namespace creepcontact::ode {

/// Wherever integration begins again at t0 and the system starts singular there, a first increment in closed form at
/// constant stress, too small to matter for the stress, leads out of the singular point; from there another integrator
/// goes on in s = (t - t0)^m, in which the state is smooth. With fixed steps the first increment is a whole step.
class SingularStart final : public Integrator {
 public:
  SingularStart(const IntegratorInfo& method, System& system, const IntegratorOptions& options);

  std::string name() const override { return inner_->name(); }
  std::string method() const override { return inner_->method(); }
  void initialize(double t, std::span<const double> y, double step = 0) override;
  StepReport step(double t_limit) override;
  bool interpolates() const override { return inner_->interpolates(); }
  void interpolate(double t, std::span<double> y) const override;
  double time() const override { return time_; }
  std::span<const double> state() const override { return begun_ ? inner_->state() : start_; }
  double next_step() const override;

  bool at_restart_point() const override { return !begun_ || inner_->at_restart_point(); }
  bool restarts_after_every_step() const override { return inner_->restarts_after_every_step(); }
  bool restores_exactly() const override { return inner_->restores_exactly(); }
  RestartPoint save() const override;
  void restore(const RestartPoint& point) override;
  Counters counters() const override;

 private:
  /// Out of the singular point, if it is one: on to the inner integrator.
  void begin(double t_limit);
  /// Length of the first increment under error control: neither the strain it gives nor the change of stress by loads
  /// in it is as much as the tolerance. Leaves that strain in change_.
  double free_increment(double longest);
  double increment_size(double stress_time, double duration);
  /// Whoever calls step() decides its length: the inner integrator is told where to end.
  bool has_fixed_steps() const;

  System& system_;
  TimeTransformedSystem started_;
  const IntegratorOptions options_;
  std::unique_ptr<Integrator> inner_;
  bool begun_ = false;         ///< the inner integrator has taken over
  double time_ = 0;            ///< of state()
  double proposal_ = 0;        ///< of the first step, if the start is regular
  double s_begin_ = 0;         ///< of the last inner step
  double first_ = 0;           ///< length of the first increment
  std::vector<double> start_;  ///< state at the start
  std::vector<double> change_;
  std::int64_t own_steps_ = 0;
};

}  // namespace creepcontact::ode
