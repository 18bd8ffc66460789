#pragma once
/// Where a run is: its state, the integrator that carries it on, and what comes next.

#include <memory>
#include <vector>

#include "checkpoints.hpp"
#include "observer_list.hpp"
#include "run_context.hpp"
#include "schedule.hpp"
#include "step_end.hpp"

namespace creepcontact::run {

class Position {
 public:
  using Source = StepView::Source;

  /// The run is at t = 0, without strain. @param context  must outlive the object
  Position(const RunContext& context, std::unique_ptr<ode::Integrator> integrator);

  double time() const { return state_.time; }
  bool is_at_end() const { return state_.time >= schedule_.end(); }
  bool is_at_breakpoint() const { return state_.time >= schedule_.next_stop(); }
  Schedule& schedule() { return schedule_; }
  /// True if the integration can be resumed from here.
  bool is_at_restart_point() const { return integrator_->at_restart_point(); }

  StepView view(Source source) const { return {context_.observed, state_.time, state_.y, source, steps()}; }
  /// The view of a time within the last step. Valid until the next call.
  StepView view_at(double t, Source source);
  /// Adds to a summary the time reached, the integrator at work (empty if nothing creeps) and the work of the run, with
  /// that of the runs that it continues.
  void describe(Summary& summary) const;

  /// Begins the integration at the present state.
  void initialize();
  /// Takes up the loop and the time of a checkpoint. The integration goes on with resume_integration().
  void resume(const io::Checkpoint& from);
  void resume_integration(const io::Checkpoint& from, const Checkpoints& files);
  io::Checkpoint checkpoint(const Checkpoints& files) const;

  /// A step of the integrator. @throws SolverError if none can be made; the position is then the same
  StepMade step(StepEnd& step_end);
  /// Back to a time within the last step, after which no step is made.
  void stop_at(double t);
  /// The run ends within a step, of which nothing is kept. @param t  at which it began
  void abandon_step(double t) { state_.time = t; }
  /// The loads change here: what follows belongs to the next segment. @param observers  may change the state
  /// @param is_changed  they do
  void pass_breakpoint(const ObserverList& observers, bool is_changed);
  /// Goes on from the state to which the observers change the present one.
  void change(const ObserverList& observers);

 private:
  void begin_segment();
  /// The present state is that of the integrator.
  void take_state();
  /// Work that the system does not count.
  RunCounters steps() const;

  const RunContext& context_;
  std::unique_ptr<ode::Integrator> integrator_;
  RunState state_;
  Schedule schedule_;
  std::vector<double> within_;  // a state within the last step
};

}  // namespace creepcontact::run
