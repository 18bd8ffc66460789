#pragma once
/// The integrator of models in which nothing creeps: it has no state, but follows the paths of friction and of
/// plastic flow.

#include <algorithm>
#include <limits>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/ode/integrator.hpp"

namespace creepcontact::run {

/// With friction or plasticity a step accepts the equilibrium at its end, and is as long as the path allows. Without,
/// the states have nothing to do with each other: a step ends where it may and costs nothing but at output times, whose
/// states are accepted because the next contact iterations start from them.
class LoadPath final : public ode::Integrator {
 public:
  /// @param system  without a state in any process, or one that stays as it is @param outputs  ascending
  /// @param breakpoints  ascending: results there are those after the loads have changed. All must outlive the object
  LoadPath(creep::CreepSystem& system, const std::vector<double>& outputs, const std::vector<double>& breakpoints)
      : system_(system), outputs_(outputs), breakpoints_(breakpoints) {}

  std::string name() const override { return {}; }
  void initialize(double t, std::span<const double> y, double step = 0) override;
  /// @throws RecoverableError if there is no equilibrium on the way, however short the steps
  ode::StepReport step(double t_limit) override;
  void interpolate(double /*t*/, std::span<double> y) const override { std::ranges::copy(state_, y.begin()); }
  double time() const override { return time_; }
  std::span<const double> state() const override { return state_; }
  double next_step() const override { return 0; }
  ode::RestartPoint save() const override;
  void restore(const ode::RestartPoint& point) override;
  /// All zero: these steps are not steps of an integration.
  Counters counters() const override { return {}; }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  void follow_path(double t_limit);
  /// Without a path: accepts the present state if it is that of an output time.
  void accept_output();

  creep::CreepSystem& system_;
  const std::vector<double>& outputs_;
  const std::vector<double>& breakpoints_;
  std::vector<double> state_;
  double time_ = 0;
  double target_ = none;  // time that the steps along a path lead to
  double length_ = 0;     // of the next one of them, if nothing else bounds it
  double accepted_ = 0;   // last output time accepted, without a path
  static constexpr auto saved_members =
      std::tuple{Member{"target", &LoadPath::target_}, Member{"length", &LoadPath::length_},
                 Member{"accepted", &LoadPath::accepted_}};
};

}  // namespace creepcontact::run
