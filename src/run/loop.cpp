#include "loop.hpp"

#include <algorithm>

#include "condition_search.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/run/summary.hpp"

namespace creepcontact::run {

using Source = StepView::Source;

Loop::Loop(const RunContext& context, const ObserverList& observers, std::unique_ptr<ode::Integrator> integrator,
           Checkpoints& checkpoints)
    : context_(context),
      observers_(observers),
      checkpoints_(checkpoints),
      position_(context, std::move(integrator)),
      step_end_(context.config, context.model, context.system(), context.integrates),
      restart_points_(observers, checkpoints),
      reporter_(context, observers, position_, restart_points_) {}

End Loop::run(const io::Checkpoint* resumed) {
  const platform::Interrupt interrupt;
  Reaction reaction = Reaction::advance;
  try {
    if (resumed == nullptr)
      reaction = start();
    else if (resume(*resumed))
      return End::completed;
    while (reaction != Reaction::stop && !position_.is_at_end() && !context_.team().any(interrupt.requested())) {
      const bool is_due = restart_points_.is_due();
      if (is_due || !context_.integrates || restart_points_.is_worth_keeping(context_.system().size()))
        keep_restart_point();
      if (is_due) restart_points_.write();
      reaction = step();
      if (reaction != Reaction::go_back) continue;
      observers_.undo();
      position_.change(observers_);
    }
    if (reaction != Reaction::stop) keep_restart_point();
    restart_points_.complete_files();
  } catch (const Cancelled&) {
    restart_points_.write();  // what the step has changed is not saved: the restart point before it is
    if (!context_.integrates && restart_points_.newest_time()) position_.abandon_step(*restart_points_.newest_time());
    return End::interrupted;
  } catch (const RecoverableError& error) {
    restart_points_.write();
    throw SolverError(error.what());
  } catch (const Error&) {
    restart_points_.write();
    throw;
  }
  restart_points_.write();
  if (reporter_.is_ruptured()) return End::ruptured;
  return reaction == Reaction::stop || position_.is_at_end() ? End::completed : End::interrupted;
}

Reaction Loop::start() {
  reporter_.output();
  const Reaction reaction = find_conditions(position_.time());
  position_.initialize();
  if (reaction == Reaction::stop) keep_restart_point();
  return reaction;
}

bool Loop::resume(const io::Checkpoint& from) {
  position_.resume(from);
  observers_.restore(from.arrays);
  step_end_.restore(from.arrays);
  if (position_.is_at_end()) {  // killed between its last checkpoint and its last summary
    reporter_.output();
    return true;
  }
  position_.resume_integration(from, checkpoints_);
  reporter_.tell_again();  // as the uninterrupted run has, so that the next step costs the same
  return false;
}

Reaction Loop::step() {
  StepView now = position_.view(Source::exact);
  if (const Reaction reaction = observers_.ask(&Observer::begin, now); reaction != Reaction::advance) {
    if (reaction == Reaction::restart) position_.change(observers_);
    return reaction;
  }
  StepMade made;
  try {
    made = position_.step(step_end_);
  } catch (const SolverError&) {
    if (observers_.is_tentative()) return Reaction::go_back;
    if (observers_.ask(&Observer::failure, now) != Reaction::stop) throw;
    reporter_.output_end();
    return Reaction::stop;
  }
  StepView at_end = position_.view(Source::exact);
  at_end.step = &made;
  Reaction reaction = observers_.ask(&Observer::step, at_end);
  if (reaction == Reaction::go_back) return reaction;
  reaction = std::max(reaction, find_conditions(position_.time() - made.report.step));
  if (reaction != Reaction::stop) return end_step();
  reporter_.output_end();
  return reaction;
}

Reaction Loop::end_step() {
  const bool is_breakpoint = position_.is_at_breakpoint();
  reporter_.output_before_now();
  Schedule& schedule = position_.schedule();
  const bool is_output = schedule.next_output() == position_.time();
  // An output of this very state follows, unless the loads jump in between.
  if (!is_output || (is_breakpoint && !position_.is_at_end())) reporter_.tell(&Observer::state);
  Reaction reaction = Reaction::advance;
  if (is_breakpoint) {
    StepView before = position_.view(Source::exact);
    reaction = observers_.ask(&Observer::segment, before);
    if (reaction == Reaction::go_back) return reaction;
    position_.pass_breakpoint(observers_, reaction != Reaction::advance);
    reporter_.tell(&Observer::jump);
  }
  if (is_output) {
    reporter_.output(reaction == Reaction::stop);
    schedule.pass_output();
  }
  if (reaction == Reaction::stop) {
    reporter_.output_end();
    keep_restart_point();
  } else if (is_breakpoint && find_conditions(position_.time()) == Reaction::stop) {  // the loads jump here
    reporter_.output_end();
    return Reaction::stop;
  }
  return reaction;
}

Reaction Loop::find_conditions(double from) {
  const auto lap = context_.watch.lap(Part::observe);
  const auto view_at = [&](double t) { return position_.view_at(t, Source::exact); };
  // No later step would find what begins to hold at a breakpoint, or at the end of the run.
  const NearEnd near_end = position_.is_at_breakpoint() || from == position_.time() ? NearEnd() : [&] {
    return position_.view(Source::accepted);
  };
  const std::optional<double> stop = run::find_conditions(from, position_.time(), view_at, near_end, observers_);
  if (!stop) return Reaction::advance;
  position_.stop_at(*stop);
  return Reaction::stop;
}

void Loop::keep_restart_point() {
  const auto lap = context_.watch.lap(Part::output);
  // The end counts as a restart point: the user may extend the run.
  if (!position_.is_at_end() && !(position_.is_at_restart_point() && observers_.is_at_restart_point())) return;
  io::Checkpoint here = position_.checkpoint(checkpoints_);
  observers_.save(here.arrays);
  step_end_.save(here.arrays);
  restart_points_.keep(std::move(here));
}

void Loop::describe(Summary& summary) const {
  summary.has_output = summary.is_resumed || reporter_.has_output();
  position_.describe(summary);
}

}  // namespace creepcontact::run
