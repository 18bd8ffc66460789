#include "position.hpp"

#include <algorithm>

#include "creepcontact/run/summary.hpp"

namespace creepcontact::run {

Position::Position(const RunContext& context, std::unique_ptr<ode::Integrator> integrator)
    : context_(context),
      integrator_(std::move(integrator)),
      schedule_(context.config.time.output, context.model.breakpoints, context.config.time.end),
      within_(context.system().size()) {
  state_.y = context.system().initial_state();
  schedule_.begin(state_.time);
  begin_segment();
}

StepView Position::view_at(double t, Source source) {
  if (t == state_.time) return view(source);
  integrator_->interpolate(t, within_);
  return {context_.observed, t, within_, source, steps()};
}

void Position::describe(Summary& summary) const {
  summary.results.time_reached = state_.time;
  summary.results.method = integrator_->method();
  static_cast<RunCounters&>(summary.results) = steps() + context_.system().run_counters();
}

RunCounters Position::steps() const {
  RunCounters result = state_.earlier;
  const ode::Integrator::Counters steps = integrator_->counters();
  result.steps += steps.steps;
  result.rejected_steps += steps.rejected_steps;
  result.convergence_failures += steps.convergence_failures;
  return result;
}

void Position::resume(const io::Checkpoint& from) {
  state_ = Checkpoints::run_state(from);
  for (const double t : state_.jumps) schedule_.add_breakpoint(t);
  schedule_.begin(state_.time);
  begin_segment();
}

void Position::resume_integration(const io::Checkpoint& from, const Checkpoints& files) {
  files.restore(from, *integrator_);
  context_.system().resume(state_.time, state_.y, from.arrays);
}

io::Checkpoint Position::checkpoint(const Checkpoints& files) const {
  return files.take(state_, steps() + context_.system().run_counters(), *integrator_, context_.system());
}

StepMade Position::step(StepEnd& step_end) {
  creep::CreepSystem& system = context_.system();
  const RunCounters before = system.run_counters();
  const StepEnd::Limit limit = step_end.next(*integrator_, schedule_);
  if (limit.is_jump) {
    state_.jumps.insert(std::ranges::upper_bound(state_.jumps, limit.time), limit.time);
    schedule_.add_breakpoint(limit.time);
    begin_segment();
  }
  StepMade made;
  made.report = integrator_->step(limit.time);
  take_state();
  made.work = system.run_counters() - before;
  made.n_active_contacts = system.n_active_contacts();
  return made;
}

void Position::stop_at(double t) {
  if (t != state_.time) integrator_->interpolate(t, state_.y);
  state_.time = t;
}

void Position::pass_breakpoint(const ObserverList& observers, bool is_changed) {
  creep::CreepSystem& system = context_.system();
  if (is_changed) observers.change(state_);
  schedule_.go_to(state_.time);
  begin_segment();  // a result at a jump is that after it
  system.pass_breakpoint(state_.time, state_.y);
  if (is_changed || !is_at_end() || integrator_->jumps_with_loads()) initialize();
}

void Position::change(const ObserverList& observers) {
  observers.change(state_);
  schedule_.go_to(state_.time);
  begin_segment();
  context_.system().settle_flow(state_.time, state_.y);
  initialize();
}

void Position::begin_segment() {
  const auto [begin, end] = schedule_.segment(state_.time);
  context_.system().begin_segment(begin, end);
}

void Position::initialize() {
  integrator_->initialize(state_.time, state_.y);
  take_state();
}

void Position::take_state() {
  state_.time = integrator_->time();
  state_.y.assign(integrator_->state().begin(), integrator_->state().end());
}

}  // namespace creepcontact::run
