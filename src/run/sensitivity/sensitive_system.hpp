#pragma once
/// A system with the derivatives of its state: the forward sensitivity equations ds/dt = (df/dy) s + df/dp. Their right
/// side is a difference of the rates of two variants. Histories and contact sets are those of each.
/// Source: Hindmarsh and Serban, User documentation for CVODES, section 2.6; the difference: Bock (1981).

#include <vector>

#include "creepcontact/ode/system.hpp"
#include "variants.hpp"

namespace creepcontact::run {

/// The state is that of the run, followed by its derivative with respect to each value in units of its change.
class SensitiveSystem final : public ode::System,
                              public ode::JacobianProducts,
                              public ode::NewtonSolver,
                              public ode::SingularRate {
 public:
  /// @param variants  must outlive the object
  explicit SensitiveSystem(Variants& variants);

  std::size_t size() const override { return n_blocks_ * base_.size(); }
  void rate(double t, std::span<const double> y, std::span<double> rate) override;
  double stable_step(double t, std::span<const double> y) override { return base_.stable_step(t, block(y, 0)); }
  double end_of_segment() const override { return base_.end_of_segment(); }
  /// That of the run for each block. Derivatives that are larger than the state, in units of it, have the same relative
  /// accuracy. The norm over all blocks bounds that of each, so that the run is as accurate as without derivatives.
  std::span<const double> scale() const override { return scale_; }
  /// Sets scale() for a state that was not accepted: at the start, or where a run is resumed.
  void set_scale(std::span<const double> y);
  void accept(double t, std::span<const double> y) override;
  bool rate_has_jumped() const override { return rate_has_jumped_; }
  void forget_evaluations() override;
  ode::JacobianProducts* jacobian() override { return base_.jacobian() != nullptr ? this : nullptr; }
  ode::NewtonSolver* newton_solver() override { return base_.newton_solver() != nullptr ? this : nullptr; }
  ode::SingularRate* singular_rate() override { return base_.singular_rate() != nullptr ? this : nullptr; }
  Counters counters() const override { return base_.counters(); }

  void jacobian_times(double t, std::span<const double> y, std::span<const double> v,
                      std::span<double> product) override;
  void prepare_preconditioner(double t, std::span<const double> y) override;
  void precondition(double gamma, std::span<const double> r, std::span<double> z) override;
  void prepare_tangent(double t, std::span<const double> y, double gamma) override;
  /// With the blocks of the diagonal: the derivatives follow the state an iteration later.
  void solve_tangent(std::span<const double> r, std::span<double> z) override;
  double start_exponent(double t, std::span<const double> y) override { return base_.start_exponent(t, block(y, 0)); }
  void start_increment(double t, std::span<const double> y, double stress_time, double duration,
                       std::span<double> change) override;

 private:
  template <typename T>
  std::span<T> block(std::span<T> y, std::size_t i) const {
    return y.subspan(i * base_.size(), base_.size());
  }
  /// The derivatives of what the variants have left in results_.
  void differentiate(std::span<double> blocks, bool adds) const;

  Variants& variants_;
  creep::CreepSystem& base_;
  std::size_t n_blocks_;
  std::vector<std::vector<double>> results_;  // of the variants
  std::vector<double> scale_;
  bool rate_has_jumped_ = false;
};

}  // namespace creepcontact::run
