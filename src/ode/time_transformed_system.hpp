#pragma once
/// A system of ordinary differential equations in another time s = (t - begin)^exponent.

#include "creepcontact/ode/system.hpp"

namespace creepcontact::ode {

/// dy/ds = f dt/ds. With the exponent 1 nothing changes but the sign's place: s = t.
class TimeTransformedSystem final : public System, public JacobianProducts, public NewtonSolver {
 public:
  /// @param system  must outlive the object
  explicit TimeTransformedSystem(System& system) : system_(system) {}

  void start(double begin, double exponent) {
    begin_ = begin;
    exponent_ = exponent;
    s_limit_ = -1;
  }
  double begin() const { return begin_; }
  double exponent() const { return exponent_; }

  double s(double t) const;
  double t(double s) const;
  /// The time that s(t_limit) represents exactly, without rounding.
  void set_limit(double t_limit) {
    t_limit_ = t_limit;
    s_limit_ = s(t_limit);
  }
  double s_limit() const { return s_limit_; }

  std::size_t size() const override { return system_.size(); }
  const Team& team() const override { return system_.team(); }
  void rate(double s, std::span<const double> y, std::span<double> rate) override;
  void jacobian_times(double s, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override;
  void prepare_preconditioner(double s, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override {
    system_.jacobian()->precondition(gamma * prepared_speed_, r, z);
  }
  JacobianProducts* jacobian() override { return system_.jacobian() != nullptr ? this : nullptr; }
  NewtonSolver* newton_solver() override { return system_.newton_solver() != nullptr ? this : nullptr; }
  void prepare_tangent(double s, std::span<const double> y, double gamma) override {
    system_.newton_solver()->prepare_tangent(t(s), y, gamma * speed(s));
  }
  void solve_tangent(std::span<const double> r, std::span<double> z) override {
    system_.newton_solver()->solve_tangent(r, z);
  }
  double stable_step(double s, std::span<const double> y) override;
  double end_of_segment() const override { return s(system_.end_of_segment()); }
  std::span<const double> scale() const override { return system_.scale(); }
  void accept(double s, std::span<const double> y) override { system_.accept(t(s), y); }
  void forget_evaluations() override { system_.forget_evaluations(); }
  Counters counters() const override { return system_.counters(); }

 private:
  double speed(double s) const;  ///< dt/ds

  System& system_;
  double begin_ = 0, exponent_ = 1;
  double t_limit_ = 0, s_limit_ = -1;
  double prepared_speed_ = 1;
};

}  // namespace creepcontact::ode
