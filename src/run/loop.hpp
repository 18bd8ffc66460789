#pragma once
/// The loop of a run: steps from output time to output time and from breakpoint to breakpoint, and what observers ask.

#include <memory>

#include "observer_list.hpp"
#include "position.hpp"
#include "reporter.hpp"
#include "restart_points.hpp"

namespace creepcontact::run {

class Loop {
 public:
  /// @param context, observers, checkpoints  must outlive the object @param integrator  with the state of the system
  Loop(const RunContext& context, const ObserverList& observers, std::unique_ptr<ode::Integrator> integrator,
       Checkpoints& checkpoints);

  /// From t = 0, or from where the checkpoint was taken, to the end. An interruption ends the loop between two steps
  /// or, through the contact iterations of the solver, within one.
  /// @throws SolverError if the run cannot go on; what was computed is on disk, a checkpoint too
  End run(const io::Checkpoint* resumed);

  /// Adds what the loop knows to a summary.
  void describe(Summary& summary) const;

 private:
  /// Takes up the state of the checkpoint. @returns true if the run was over there, and only its end was not reported
  bool resume(const io::Checkpoint& from);
  /// The first output, and what holds at once. @returns stop if this ends the run
  Reaction start();
  /// A step, and what follows up to the next one.
  Reaction step();
  /// From the end of a step to the beginning of the next one.
  Reaction end_step();
  /// Conditions that begin to hold in (from, now] on the states of the last step. A stop moves the position to it.
  Reaction find_conditions(double from);
  void keep_restart_point();

  const RunContext& context_;
  const ObserverList& observers_;
  Checkpoints& checkpoints_;
  Position position_;
  StepEnd step_end_;
  RestartPoints restart_points_;
  Reporter reporter_;
};

}  // namespace creepcontact::run
