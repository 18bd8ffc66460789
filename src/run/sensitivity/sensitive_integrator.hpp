#pragma once
/// The integrator of a run with derivatives: the loop sees the state of the run alone.

#include <functional>
#include <memory>
#include <vector>

#include "creepcontact/ode/integrator.hpp"
#include "sensitive_system.hpp"

namespace creepcontact::run {

class SensitiveIntegrator final : public ode::Integrator {
 public:
  /// @param make_inner  the integrator of a system
  SensitiveIntegrator(std::unique_ptr<Derivatives> derivatives,
                      const std::function<std::unique_ptr<ode::Integrator>(ode::System&)>& make_inner);

  std::string name() const override { return inner_->name(); }
  std::string method() const override { return inner_->method(); }
  /// The derivatives go on from what they are.
  void initialize(double t, std::span<const double> y, double step = 0) override;
  bool jumps_with_loads() const override { return inner_->jumps_with_loads(); }
  ode::StepReport step(double t_limit) override;
  bool interpolates() const override { return inner_->interpolates(); }
  void interpolate(double t, std::span<double> y) const override;
  double time() const override { return inner_->time(); }
  std::span<const double> state() const override { return inner_->state().first(n_); }
  double next_step() const override { return inner_->next_step(); }
  bool at_restart_point() const override { return inner_->at_restart_point(); }
  bool restarts_after_every_step() const override { return inner_->restarts_after_every_step(); }
  ode::RestartPoint save() const override;
  void restore(const ode::RestartPoint& point) override;
  Counters counters() const override { return inner_->counters(); }

  Derivatives& of() { return *of_; }
  /// State and derivatives, see Derivatives. @param t  within the last step
  std::vector<double> whole_at(double t) const;
  /// The derivatives at the end of the last step, see Derivatives; and those from which to go on.
  std::vector<double> derivatives() const;
  void set_derivatives(std::span<const double> derivatives);
  /// The beginning of the last step.
  double begin_of_step() const { return begin_; }

 private:
  std::unique_ptr<Derivatives> of_;
  SensitiveSystem system_;
  std::unique_ptr<ode::Integrator> inner_;
  std::size_t n_;
  std::vector<double> whole_;  // before the first step, and at the last restart
  bool has_stepped_ = false;   // since then
  double begin_ = 0;
};

}  // namespace creepcontact::run
