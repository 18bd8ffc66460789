#pragma once
/// What watches a run: result files, extremes, events, cycles, damage, progress, each an Observer of its own.

#include <cstddef>
#include <string>
#include <vector>

#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/run/run_state.hpp"
#include "creepcontact/run/step_view.hpp"

namespace creepcontact::run {

struct Summary;

/// What an observer asks of the loop. If observers differ, the last answer in this list wins.
enum class Reaction {
  advance,  ///< go on
  restart,  ///< the integration restarts from the state that change() gives
  stop,     ///< the run ends here
  go_back   ///< all that is tentative is undone, and the run goes on from the state that change() gives
};

/// How a run has ended. A run that is stopped by an observer is completed.
enum class End { completed, ruptured, interrupted, failed };

/// The loop calls the members in the order of the steps, for all observers in the order of their list. All calls are
/// collective. Errors that a call throws end the run; what was computed is kept.
///
/// A step: begin, step, condition (if any holds at its end), output (times before its end), state, and at a breakpoint
/// segment and jump; then output, if its end is an output time.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Before a step from this state.
  virtual Reaction begin(StepView& /*view*/) { return Reaction::advance; }
  /// After a step; a stop within it may still shorten it. `view.step` describes it.
  virtual Reaction step(StepView& /*view*/) { return Reaction::advance; }
  /// No step can be made from this state. `stop`: the run ends here without an error.
  virtual Reaction failure(StepView& /*view*/) { return Reaction::advance; }
  /// A state of the run between output times: the end of a step, or a breakpoint before the loads change.
  virtual void state(StepView& /*view*/) {}
  /// A breakpoint, before the loads change there.
  virtual Reaction segment(StepView& /*view*/) { return Reaction::advance; }
  /// A breakpoint, after the loads have changed there.
  virtual void jump(StepView& /*view*/) {}
  /// An output time, or the end of the run; they come in increasing order.
  virtual void output(StepView& /*view*/) {}
  /// After `restart` or `go_back`: the time and the state from which the run goes on.
  virtual void change(RunState& /*state*/) {}
  /// The run does not go back behind the present state any more: what was tentative counts.
  virtual void keep() {}
  /// The run has gone back: what was tentative does not count.
  virtual void undo() {}

  /// Conditions that begin to hold at an instant, which the loop locates: their numbers, as far as they hold in this
  /// state and have not happened.
  virtual std::vector<std::size_t> conditions(StepView& /*view*/) const { return {}; }
  /// Values on which one of them depends, apart from the time, and which are smooth in it: from a few of them the loop
  /// guesses the instant. Empty: it halves the step instead, as often as resolution() wants. @param number  from
  /// conditions()
  virtual std::vector<double> values(std::size_t /*number*/, StepView& /*view*/) const { return {}; }
  /// Whether one of them would hold at this time with these values. Not asked without values.
  virtual bool would_hold(std::size_t /*number*/, double /*time*/, std::span<const double> /*values*/) const {
    return false;
  }
  /// Whether one of them holds.
  virtual bool holds(std::size_t number, StepView& view) const {
    return would_hold(number, view.time(), values(number, view));
  }
  /// One of them begins to hold in this state.
  virtual void happened(std::size_t /*number*/, StepView& /*view*/) {}
  /// True if it ends the run.
  virtual bool stops(std::size_t /*number*/) const { return false; }
  /// Accuracy of the instant, relative to the step.
  virtual double resolution() const { return 1e-10; }

  /// True while the run may go back behind the present state: change() then gives the state to go back to.
  virtual bool may_go_back() const { return false; }
  /// True if nothing that save() leaves out would be lost here.
  virtual bool at_restart_point() const { return true; }
  /// Adds what later calls depend on. Names begin with that of the observer.
  virtual void save(creep::Memory& /*memory*/) const {}
  /// The reverse, before the first other call. Entries may be missing: the configuration may have changed.
  virtual void restore(const creep::Memory& /*memory*/) {}
  /// True while files are being written. @see wait
  virtual bool is_writing() const { return false; }
  /// Returns when no file is being written any more. @throws Error if the disk does not take one. Not collective.
  virtual void wait() {}
  /// All that is written is on the disk itself when it returns. @throws Error if it cannot take it. Not collective.
  virtual void sync() {}

  /// Once, when the run has ended: last messages.
  virtual void end(End /*how*/) {}
  /// Adds what it knows to the summary; may be called at any time.
  virtual void finish(Summary& /*summary*/) const {}
};

}  // namespace creepcontact::run
