#include "time_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/contact/solver/friction_uniqueness.hpp"
#include "creepcontact/results/contact_width.hpp"
#include "creepcontact/results/equilibrium_residual.hpp"
#include "elastic_path.hpp"
#include "event_search.hpp"
#include "preparation.hpp"

namespace creepcontact::run {
namespace {

/// Damage at which steps that shrink to nothing mean rupture: the rate of damage is then infinite.
constexpr double almost_ruptured = 0.5;
constexpr int steps_between_warnings = 50;
constexpr double no_time = 1e-9;         // relative to the time
constexpr double longest_stretch = 1.1;  // of the step that an integrator proposes
constexpr const char* jumps_name = "run.jumps";
constexpr double failing_with = 0.9;  // damage at which steps that cannot be made mean rupture

}  // namespace

TimeLoop::TimeLoop(const config::Config& config, const model::Model& model, const creep::Distribution& distribution,
                   creep::CreepSystem& system, std::vector<std::unique_ptr<results::Probe>> probes, Stopwatch& watch,
                   const std::filesystem::path& directory, bool resume, RunObserver* observer)
    : config_(config),
      model_(model),
      distribution_(distribution),
      system_(system),
      whole_(distribution, system),
      watch_(watch),
      checkpoints_(config, model, distribution, directory),
      probes_(std::move(probes)),
      observer_(observer),
      life_(system),
      outcome_(model.assembly),
      probe_record_(config.probes.size()),
      small_strains_(system),
      table_ranges_(config),
      data_ranges_(config),
      state_(system.size(), 0.0) {
  io::Continuation continuation;
  if (resume) {
    resumed_ = checkpoints_.read();
    time_ = resumed_->time;
    has_output_ = true;
    earlier_ = resumed_->counters;
    system.restore(resumed_->arrays);
    outcome_.restore(resumed_->arrays);
    probe_record_.restore(resumed_->arrays);
    small_strains_.restore(resumed_->arrays);
    continuation = {.resume = true, .last_time = time_};
  } else if (distribution.is_root()) {
    checkpoints_.remove();
  }
  together(distribution.team(), [&] {
    results_ =
        std::make_unique<results::Results>(config, directory, model.assembly, continuation, distribution.is_root());
  });
  events_.emplace(config, probes_);
  if (resumed_) events_->restore(resumed_->arrays);
  if (model.cycles)
    cycles_.emplace(config, *model.cycles, system, whole_, probes_, directory, time_,
                    resumed_ ? &resumed_->arrays : nullptr);
  integrator_ = make_integrator(config.time, model, system);
  preloads_.emplace(system, model.breakpoints, config.time.end, resumed_ ? time_ : -1);
  extremes_.emplace(whole_, probes_, outcome_, probe_record_, small_strains_, config.time.tolerance);
  next_output_ = std::upper_bound(config.time.output.begin(), config.time.output.end(), time_);
  breakpoints_ = model.breakpoints;
  if (resumed_)
    if (const auto found = resumed_->arrays.find(jumps_name); found != resumed_->arrays.end())
      for (const double t : found->second) add_breakpoint(t);
  find_next_breakpoint();
  if (integrator_) {
    guard_.emplace(config, model, system);
    if (resumed_) guard_->restore(resumed_->arrays);
  }
}

void TimeLoop::find_next_breakpoint() {
  next_break_ = static_cast<std::size_t>(std::ranges::upper_bound(breakpoints_, time_) - breakpoints_.begin());
}

void TimeLoop::add_breakpoint(double t) {
  const auto after = std::ranges::lower_bound(breakpoints_, t);
  if (after == breakpoints_.end() || *after != t) breakpoints_.insert(after, t);
}

io::Checkpoint TimeLoop::checkpoint() const {
  io::Checkpoint checkpoint = checkpoints_.take(time_, integrator_.get(), system_);
  outcome_.save(checkpoint.arrays);
  probe_record_.save(checkpoint.arrays);
  small_strains_.save(checkpoint.arrays);
  events_->save(checkpoint.arrays);
  if (cycles_) cycles_->save(checkpoint.arrays);
  if (guard_) guard_->save(checkpoint.arrays);
  if (breakpoints_.size() > model_.breakpoints.size())
    std::ranges::set_difference(breakpoints_, model_.breakpoints, std::back_inserter(checkpoint.arrays[jumps_name]));
  checkpoint.counters = counters();
  return checkpoint;
}

void TimeLoop::finish_fields() {
  const bool settled = std::exchange(settled_, false);
  std::optional<io::Checkpoint> later = std::exchange(after_fields_, {});  // dropped if they fail
  wait_for_fields();
  settled_ = settled;
  if (later) kept_ = std::move(later);
}

bool TimeLoop::interrupted(const platform::Interrupt& interrupt) const {
  return distribution_.team().any(interrupt.requested());
}

void TimeLoop::wait_for_fields() {
  together(distribution_.team(), [&] { results_->wait(); });
}

void TimeLoop::keep_restart_point() {
  if (!at_restart_point()) return;
  const bool writing = distribution_.team().any(results_->is_writing());
  if (!writing) finish_fields();
  // The copy costs little against a step, but not nothing: made if the next restart point may be far, a result that
  // fails to be written may spoil the step, or rupture may end within it.
  const bool far = cycles_ || !integrator_->restarts_after_every_step();
  const double reach = 2 * integrator_->next_step();
  const bool output_ahead = next_output_ != config_.time.output.end() && (reach == 0 || *next_output_ <= time_ + reach);
  std::optional<io::Checkpoint>& here = writing ? after_fields_ : kept_;
  here.reset();
  // Within the step, also on request: contact iterations heed signals.
  const bool may_end =
      system_.has(material::damage) || events_->is_waiting() || system_.solver().interface().n_rows() > 0;
  if (far || output_ahead || may_end) here = checkpoint();
}

void TimeLoop::write_checkpoint() {
  const auto lap = watch_.lap(Part::output);
  // The end is one for whoever prolongs the run.
  finish_fields();
  const bool here = settled_ && (at_restart_point() || time_ >= config_.time.end);
  if (!here && !kept_) return;
  together(distribution_.team(), [&] {  // a checkpoint stands for all results before it
    results_->sync();
    if (cycles_) cycles_->sync();
  });
  checkpoints_.write(here ? checkpoint() : *kept_);
}

RunCounters TimeLoop::counters() const {
  RunCounters result = earlier_ + system_.run_counters();
  if (!integrator_) return result;
  const ode::Integrator::Counters steps = integrator_->counters();
  result.steps += steps.steps;
  result.rejected_steps += steps.rejected_steps;
  result.convergence_failures += steps.convergence_failures;
  return result;
}

void TimeLoop::output(double t, std::span<const double> y) {
  const creep::Evaluation& own = system_.evaluate_result(t, y);
  {
    const auto lap = watch_.lap(Part::output);
    if (after_fields_) finish_fields();  // a restart point before this output
    const bool is_end = t == config_.time.end || stopped_;
    life_.output(own);
    const std::vector<double> values = whole_.look(t, y, [&](results::Snapshot& snapshot) {
      const creep::Equilibrium& at = snapshot.equilibrium();
      std::vector<double> probe_values = results::probe_values(probes_, snapshot);
      results_->output(snapshot, probe_values);
      probe_record_.output(t, probe_values);
      outcome_.output(t, at);
      if (t == 0 || is_end) see_uniqueness(at);
      if (is_end) equilibrium_residual_ = results::equilibrium_residual(snapshot);
      if (is_end) narrow_contacts_ = results::narrow_contacts(model_.assembly, at, "at the end");
      if (is_end) std::ranges::copy(outcome_.narrow_contacts(), std::back_inserter(narrow_contacts_));
      return probe_values;
    });
    if (cycles_) cycles_->see_probes(values);
    last_output_ = t;
    life_.warn(t, own, own.y);
    table_ranges_.see(own.time, system_.assembly().bodies(), own.equilibrium, distribution_.team());
    data_ranges_.see(system_.assembly().bodies(), own.equilibrium, distribution_.team());
    small_strains_.see(t, own);
    has_output_ = true;
  }
  if (after_output) after_output();
}

void TimeLoop::see_uniqueness(const creep::Equilibrium& at) {
  if (!system_.has_friction()) return;
  const contact::CondensedInterface& interface = system_.solver().interface();
  const auto kappa = contact::friction_kappa(interface.problem(), interface.friction(at.time), at.contact);
  if (!kappa) return;
  if (*kappa > 1 && !(friction_kappa_.value_or(0) > 1))
    log::warning(
        "friction: kappa = {:.3g} at t = {:.6g}. Above 1 the bodies may lock, and several states of stick and slip may "
        "be "
        "possible under the same loads; the run follows the one that the loading from the unloaded state leads to "
        "(docs/contact.md)",
        *kappa, at.time);
  friction_kappa_ = std::max(friction_kappa_.value_or(0), *kappa);
}

TimeLoop::End TimeLoop::run() {
  const platform::Interrupt interrupt;
  bool cancelled = false;
  try {
    begin_segment();
    if (time_ >= config_.time.end) {  // killed between its last checkpoint and its last summary, which is made up for
      const creep::Evaluation& at = system_.evaluate_output(time_, resumed_->state);
      life_.output(at);
      whole_.look(time_, resumed_->state, [&](results::Snapshot& snapshot) -> std::vector<double> {
        outcome_.output(time_, snapshot.equilibrium());
        return {};
      });
      return End::completed;
    }
    if (!resumed_) output(0, state_);
    settled_ = !integrator_;
    if (!resumed_ && stopped_at_once(state_)) {
      if (integrator_) integrator_->initialize(time_, state_);
      settled_ = true;
    } else if (integrator_) {
      integrate(interrupt);
    } else {
      elastic_history(interrupt);
    }
    finish_fields();
  } catch (const Cancelled&) {
    cancelled = true;
    settled_ = false;  // what the step has changed is not saved: the restart point before it is
    if (!integrator_ && kept_) time_ = kept_->time;
    if (observer_ != nullptr) observer_->before_message();
  } catch (const RecoverableError& error) {
    write_checkpoint();
    throw SolverError(error.what());
  } catch (const SolverError&) {
    write_checkpoint();
    // Right before rupture steps may have become as short as numbers allow.
    if (!integrator_ || !settled_ || life_.largest_damage(integrator_->state()).value < failing_with) throw;
    report_rupture(time_, life_.largest_damage(integrator_->state()));
    output(time_, integrator_->state());
  } catch (const Error&) {
    write_checkpoint();
    throw;
  }
  write_checkpoint();
  if (cancelled) return End::interrupted;
  if (ruptured_ || stopped_ || time_ >= config_.time.end) table_ranges_.finish();
  if (ruptured_) return End::ruptured;
  if (time_ < config_.time.end && !stopped_) return End::interrupted;
  if (distribution_.is_root()) outcome_.warn_of_open_contacts();
  return End::completed;
}

model::StepGuard::Segment TimeLoop::segment() const {
  constexpr double never = std::numeric_limits<double>::infinity();
  // At the end of the run there is no state after a jump that would still be integrated, but one to be reported.
  const double last = time_ < config_.time.end ? config_.time.end : never;
  return {.begin = next_break_ > 0 ? breakpoints_[next_break_ - 1] : -never,
          .end = next_break_ < breakpoints_.size() ? breakpoints_[next_break_] : last};
}

void TimeLoop::begin_segment() {
  const auto [begin, end] = segment();
  system_.begin_segment(begin, end);
}

void TimeLoop::report_rupture(double time, const creep::CreepSystem::Extreme& where) {
  ruptured_ = true;
  life_.rupture(time, where);
  if (observer_ != nullptr) observer_->before_message();
  log::info("body '{}' ruptures at t = {:.6g}: damage {:.3g} at ({:.6g}, {:.6g}, {:.6g})",
            model_.bodies()[where.body].name(), time, where.value, where.position.x(), where.position.y(),
            where.position.z());
}

bool TimeLoop::ruptured(double begin_of_step) {
  creep::CreepSystem::Extreme where = life_.largest_damage(integrator_->state());
  const bool at_end = life_.is_rupture(where, time_, integrator_->state());
  if (!at_end && !(where.value >= almost_ruptured && time_ - begin_of_step < no_time * time_)) return false;
  double before = begin_of_step, after = time_;
  for (int halving = 0; at_end && halving < 50; ++halving) {
    const double middle = 0.5 * (before + after);
    if (middle == before || middle == after) break;
    integrator_->interpolate(middle, state_);
    const creep::CreepSystem::Extreme there = life_.largest_damage(state_);
    const bool is_rupture = life_.is_rupture(there, middle, state_);
    (is_rupture ? after : before) = middle;
    if (is_rupture) where = there;
  }
  time_ = after;
  if (stopped_in_step(begin_of_step)) return true;
  outputs_of_step(false);
  integrator_->interpolate(time_, state_);
  output(time_, state_);
  report_rupture(time_, where);
  return true;
}

void TimeLoop::begin_cycle() {
  const double next_output =
      next_output_ != config_.time.output.end() ? *next_output_ : std::numeric_limits<double>::infinity();
  const std::span<const double> y = integrator_->state();
  state_.assign(y.begin(), y.end());
  const std::optional<double> to = cycles_->jump(time_, next_output, state_);
  try {
    if (to) continue_at(*to);
    cycles_->begin(time_, integrator_->state());
  } catch (const RecoverableError&) {  // the state after the jump has no equilibrium
    if (!to) throw;
    go_back_before_jump();
    cycles_->begin(time_, integrator_->state());
  }
}

void TimeLoop::continue_at(double t) {
  time_ = t;
  find_next_breakpoint();
  begin_segment();
  integrator_->initialize(time_, state_);
}

void TimeLoop::go_back_before_jump() {
  held_steps_.clear();
  extremes_->drop();
  continue_at(cycles_->go_back(state_));
  settled_ = true;
}

bool TimeLoop::gone_back_for_event() {
  bool happened = life_.largest_damage(integrator_->state()).value >= almost_ruptured;
  if (!happened && events_->is_waiting())
    happened = !whole_
                    .look(time_, integrator_->state(),
                          [&](results::Snapshot& snapshot) {
                            return std::vector<double>(events_->holding(snapshot).empty() ? 0 : 1);
                          })
                    .empty();
  if (happened) go_back_before_jump();
  return happened;
}

void TimeLoop::record_step(const ode::StepReport& report, const RunCounters& work) {
  held_steps_.push_back({report, work, system_.n_active_contacts()});
  if (!cycles_ || !cycles_->is_checking()) write_held_steps();
}

void TimeLoop::write_held_steps() {
  together(distribution_.team(), [&] {
    for (const HeldStep& step : held_steps_) results_->step(step.report, step.work, step.n_active_contacts);
  });
  held_steps_.clear();
}

void TimeLoop::see_extremes(std::span<const double> y) {
  try {
    extremes_->see(time_, system_.evaluate_accepted(time_, y));
  } catch (const RecoverableError&) {  // the integrator meets it next, and decides what becomes of the run
  }
}

void TimeLoop::keep_extremes() {
  if (!cycles_ || !cycles_->is_checking()) extremes_->keep();
}

bool TimeLoop::end_of_segment() {
  cycles_->see(time_, integrator_->state());
  const std::span<const double> y = integrator_->state();
  state_.assign(y.begin(), y.end());
  const Cycles::Closed closed = cycles_->close(time_, counters(), state_);
  if (closed.is_rejected) {
    held_steps_.clear();
    extremes_->drop();
    continue_at(closed.time);
    return false;
  }
  if (!cycles_->is_checking()) write_held_steps();
  restarts_ = closed.state_changed;
  stopped_ = closed.is_steady;
  return true;
}

bool TimeLoop::outputs_of_step(bool breakpoint) {
  const auto end = config_.time.output.end();
  for (; next_output_ != end && *next_output_ < time_; ++next_output_) {
    integrator_->interpolate(*next_output_, state_);
    output(*next_output_, state_);
  }
  if (breakpoint && cycles_ && !end_of_segment()) return false;
  keep_extremes();
  if (breakpoint) {
    begin_segment();  // a result at a jump is that after it
    if (restarts_) integrator_->initialize(time_, state_);
    system_.apply_preloads(time_, integrator_->state());
    if (system_.has_friction()) system_.accept(time_, integrator_->state());  // slip in the jump
  }
  if (breakpoint && integrator_->jumps_with_loads()) integrator_->initialize(time_, integrator_->state());
  if (breakpoint && cycles_) cycles_->see_after_jump(time_, integrator_->state());
  if (next_output_ != end && *next_output_ == time_ && time_ == integrator_->time()) {
    output(time_, integrator_->state());
    ++next_output_;
  }
  return true;
}

void TimeLoop::integrate(const platform::Interrupt& interrupt) {
  const double end = config_.time.end;
  if (resumed_) {
    restore(*resumed_, config_, *integrator_);
    system_.resume(time_, integrator_->state(), resumed_->arrays);
    // The uninterrupted run has looked at the state here, too, so that the next step costs the same.
    if (std::ranges::binary_search(model_.breakpoints, time_)) see_extremes(integrator_->state());
    extremes_->drop();
  } else {
    integrator_->initialize(time_, state_);
  }
  resumed_.reset();
  settled_ = true;
  while (time_ < end && !interrupted(interrupt)) {
    if (checkpoints_.due()) write_checkpoint();
    keep_restart_point();
    if (cycles_ && cycles_->is_between()) begin_cycle();
    const RunCounters before = system_.run_counters();
    const double limit = end_of_step();
    const double stop = next_break_ < breakpoints_.size() ? breakpoints_[next_break_] : end;
    ode::StepReport report;
    try {
      report = integrator_->step(limit);
    } catch (const SolverError&) {
      if (!cycles_ || !cycles_->is_checking()) throw;
      go_back_before_jump();
      continue;
    }
    settled_ = false;
    time_ = integrator_->time();
    record_step(report, system_.run_counters() - before);
    step_statistics_.see(report);
    const creep::Evaluation& last = system_.step_evaluation();
    table_ranges_.see(last.time, system_.assembly().bodies(), last.equilibrium, distribution_.team());
    data_ranges_.see(system_.assembly().bodies(), last.equilibrium, distribution_.team());
    if (observer_ != nullptr) observer_->step(time_, counters());
    if (step_statistics_.n_steps() % steps_between_warnings == 0)
      life_.warn(time_, system_.step_evaluation(), integrator_->state());
    preloads_->step(time_, integrator_->state());
    if (cycles_) cycles_->step(report, integrator_->state());
    if (cycles_ && cycles_->is_checking() && gone_back_for_event()) continue;
    if (ruptured(time_ - report.step) || stopped_in_step(time_ - report.step)) return;
    const bool breakpoint = time_ >= stop;
    // An output of this very state follows, unless the loads jump in between.
    const bool is_output = next_output_ != config_.time.output.end() && *next_output_ == time_;
    if (!is_output || (breakpoint && time_ < end)) see_extremes(integrator_->state());
    if (breakpoint && next_break_ < breakpoints_.size()) ++next_break_;
    if (!outputs_of_step(breakpoint)) {
      settled_ = true;
      continue;
    }
    if (stopped_) {  // the cycles repeat
      if (last_output_ != time_) output(time_, integrator_->state());
      settled_ = true;
      break;
    }
    const bool restarted = std::exchange(restarts_, false);
    if (breakpoint && !restarted && time_ < end && !integrator_->jumps_with_loads()) {
      const std::span<const double> y = integrator_->state();
      integrator_->initialize(time_, std::vector<double>(y.begin(), y.end()));
    }
    if (breakpoint && time_ < end) {
      see_extremes(integrator_->state());
      keep_extremes();
    }
    if (breakpoint && stopped_at_once(integrator_->state())) {  // the loads jump here
      if (last_output_ != time_) output(time_, integrator_->state());
      return;
    }
    settled_ = true;
  }
  if (observer_ != nullptr) observer_->before_message();
}

double TimeLoop::end_of_step() {
  const double stop = next_break_ < breakpoints_.size() ? breakpoints_[next_break_] : config_.time.end;
  const bool interpolates = integrator_->interpolates() && !config_.time.stop_at_output;
  const bool may_pass_outputs = interpolates || next_output_ == config_.time.output.end();
  const double limit = std::min(may_pass_outputs ? stop : std::min(stop, *next_output_), longest_step_end());
  const double proposed = integrator_->next_step();
  const bool is_proposed = proposed > 0;
  const double reach = is_proposed ? std::min(limit, time_ + longest_stretch * proposed) : limit;
  const auto [begin, end] = segment();
  const auto found = guard_->end_of_step(time_, integrator_->state(), reach, is_proposed,
                                         {creep::just_after(begin), creep::just_before(end)});
  if (!found) return limit;
  if (found->is_jump) {
    add_breakpoint(found->time);
    find_next_breakpoint();
    begin_segment();
  }
  return found->time;
}

double TimeLoop::longest_step_end() const {
  const bool is_fixed = config_.time.step.mode == settings::StepMode::fixed;
  if (is_fixed) return std::numeric_limits<double>::infinity();
  return std::min(time_ + system_.longest_step(time_), model_.step_limits.latest_end(time_));
}

bool TimeLoop::stopped_within(double from, double to, const StateAt& state_at) {
  const std::optional<double> stop = find_events(from, to, state_at, whole_, *events_, observer_);
  if (!stop) return false;
  stopped_ = true;
  time_ = *stop;
  return true;
}

bool TimeLoop::stopped_in_step(double begin) {
  const auto interpolated = [&](double t) {
    integrator_->interpolate(t, state_);
    return std::span<const double>(state_);
  };
  if (!stopped_within(begin, time_, interpolated)) return false;
  outputs_of_step(false);
  if (last_output_ != time_) output(time_, interpolated(time_));
  return true;
}

bool TimeLoop::stopped_at_once(std::span<const double> y) {
  return stopped_within(time_, time_, [&](double) { return y; });
}

void TimeLoop::elastic_history(const platform::Interrupt& interrupt) {
  const auto at_rest = [&](double) { return std::span<const double>(state_); };
  ElasticPath path(system_, model_.breakpoints, state_, time_,
                   {.stops = [&](double from, double to) { return stopped_within(from, to, at_rest); },
                    .reached = [&](double t) { time_ = t; },
                    .passes =
                        [&](double t) {
                          extremes_->see_between(t, state_);
                          extremes_->keep();
                        }});
  for (; next_output_ != config_.time.output.end(); ++next_output_) {
    if (interrupted(interrupt)) return;
    if (checkpoints_.due()) write_checkpoint();
    kept_ = checkpoint();
    const double t = *next_output_;
    if (path.stopped_before(t)) return output(time_, state_);
    system_.apply_preloads(t, state_);
    system_.evaluate_step(t, state_);
    output(t, state_);
    wait_for_fields();  // before the time, from which the run is resumed
    system_.accept(t, state_);
    time_ = t;
  }
  time_ = config_.time.end;
}

}  // namespace creepcontact::run
