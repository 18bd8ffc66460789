#pragma once
/// The way of the loads without creep: nothing is integrated, but slip, preloads and events depend on what came before.

#include <functional>
#include <span>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"

namespace creepcontact::run {

/// Takes the loads of a model without creep from time to time. Calls are collective.
class ElasticPath {
 public:
  /// What the run is told on the way.
  struct Callbacks {
    /// An interval (from, to], or an instant if both are equal. True: an event in it stops the run.
    std::function<bool(double from, double to)> stops;
    /// The loads are applied up to t, and the run may be resumed from there.
    std::function<void(double t)> reached;
    /// A state on the way at t, before or after the loads jump there. The system evaluates it at no cost with friction;
    /// without, these are the first breakpoints alone.
    std::function<void(double t)> passes;
  };

  /// @param system, breakpoints, state  must outlive the object; the state is that of the internal variables, which
  /// stay
  /// @param time  from which the loads are followed
  ElasticPath(creep::CreepSystem& system, const std::vector<double>& breakpoints, const std::vector<double>& state,
              double time, Callbacks callbacks);

  /// Follows the loads from the last time to t, t included. @returns true if an event stops the run
  /// @throws RecoverableError if there is no equilibrium on the way, however short the steps
  bool stopped_before(double t);

 private:
  bool stopped_by_event(double t);
  bool stopped_with_friction(double t);
  /// Accepts the state at t, in shorter steps where one is too long.
  bool stopped_in_slip(double t);
  void begin_last_segment(double t);
  double last_breakpoint_before(double t) const;
  /// A breakpoint without friction, where the loads may have an extreme.
  void pass(double t);

  creep::CreepSystem& system_;
  const std::vector<double>& breakpoints_;
  const std::vector<double>& state_;
  double time_;
  Callbacks callbacks_;
  int n_passed_ = 0;
};

}  // namespace creepcontact::run
