#pragma once
/// A system with the derivatives of its state, as the integrator sees it.

#include <vector>

#include "creepcontact/ode/system.hpp"
#include "derivatives.hpp"

namespace creepcontact::run {

/// The state is the `whole` of Derivatives.
class SensitiveSystem final : public ode::System,
                              public ode::JacobianProducts,
                              public ode::NewtonSolver,
                              public ode::SingularRate {
 public:
  /// @param derivatives  must outlive the object
  explicit SensitiveSystem(Derivatives& derivatives);

  std::size_t size() const override { return of_.size(); }
  void rate(double t, std::span<const double> y, std::span<double> rate) override { of_.rate(t, y, rate); }
  double stable_step(double t, std::span<const double> y) override { return base_.stable_step(t, of_.block(y, 0)); }
  double end_of_segment() const override { return base_.end_of_segment(); }
  /// That of the run in its block, as if it were alone; in those of derivatives some times as much (method.md).
  /// Derivatives that are larger than the state, in units of it, have the same relative accuracy.
  std::span<const double> scale() const override { return scale_; }
  /// Sets scale() for a state that was not accepted: at the start, or where a run is resumed.
  void set_scale(std::span<const double> y);
  void accept(double t, std::span<const double> y) override {
    of_.accept(t, y);
    set_scale(y);
  }
  bool rate_has_jumped() const override { return of_.rate_has_jumped(); }
  void forget_evaluations() override { of_.forget_evaluations(); }
  ode::JacobianProducts* jacobian() override { return base_.jacobian() != nullptr ? this : nullptr; }
  ode::NewtonSolver* newton_solver() override { return base_.newton_solver() != nullptr ? this : nullptr; }
  ode::SingularRate* singular_rate() override { return base_.singular_rate() != nullptr ? this : nullptr; }
  Counters counters() const override { return base_.counters(); }

  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override {
    of_.jacobian_times(t, y, v, product);
  }
  void prepare_preconditioner(double t, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override;
  void prepare_tangent(double t, std::span<const double> y, double gamma) override;
  /// With the blocks of the diagonal: the derivatives follow the state an iteration later.
  void solve_tangent(std::span<const double> r, std::span<double> z) override;
  double start_exponent(double t, std::span<const double> y) override {
    return base_.start_exponent(t, of_.block(y, 0));
  }
  void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                       std::span<double> change) override {
    of_.start_increment(t, y, stress_time, duration, change);
  }

 private:
  Derivatives& of_;
  creep::CreepSystem& base_;
  std::vector<double> scale_;
};

}  // namespace creepcontact::run
