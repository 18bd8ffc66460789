#include "euler_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../elementwise.hpp"
#include "../first_step.hpp"
#include "../step_failures.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {

namespace {
constexpr int max_halvings = 10;
constexpr int max_adaptive_attempts = 30;
/// Relative to the time: adaptive steps that shrink beyond it creep up to a point that they will not pass.
constexpr double smallest_step = 1e-12;
}  // namespace

EulerScheme::EulerScheme(System& system, const IntegratorOptions& options, std::size_t residual_size)
    : system_(system), options_(options) {
  if (options.step.mode == StepMode::fixed && !(options.step.length > 0 && std::isfinite(options.step.length)))
    throw ConfigError(fmt::format("step = {}: must be positive, \"stable\" or \"adaptive\"", options.step.length));
  if (!(options.step_factor > 0))
    throw ConfigError(fmt::format("step_factor = {}: must be positive", options.step_factor));
  for (EulerPoint* point : {&current_, &next_, &previous_}) {
    point->state.resize(system.size());
    point->rate.resize(system.size());
    point->load_residual.resize(residual_size);
  }
  if (options.step.mode == StepMode::adaptive) doubling_.emplace(system.team(), current_, options.tolerance);
}

void EulerScheme::initialize(double t, std::span<const double> y, double step) {
  clock_.start(t);
  std::ranges::copy(y, current_.state.begin());
  std::ranges::copy(y, previous_.state.begin());
  std::ranges::fill(current_.load_residual, 0.0);
  begin_ = t;
  last_step_ = 0;
  proposal_ = adaptive() ? step : options_.step.length;
  stable_.reset();
  system_.forget_evaluations();
  if (doubling_) doubling_->set_scale(system_.scale());
  at_start(*this, t, [&] { system_.rate(t, current_.state, current_.rate); });
}

RestartPoint EulerScheme::save() const {
  RestartPoint point = Integrator::save();
  point.memory.save("lost_time", clock_.lost());
  point.memory.save("stable_step", stable_);
  point.states["rate"] = current_.rate;
  point.states["load_residual"] = current_.load_residual;  // empty in schemes that leave none
  return point;
}

void EulerScheme::restore(const RestartPoint& point) {
  current_.rate = point.states.at("rate");
  current_.load_residual = point.states.at("load_residual");
  clock_.start(point.time, point.memory.at("lost_time").at(0));
  current_.state = previous_.state = point.state;
  begin_ = point.time;
  last_step_ = 0;
  proposal_ = point.next_step;
  point.memory.restore("stable_step", stable_);
  if (doubling_) doubling_->set_scale(system_.scale());
  system_.forget_evaluations();
}

bool EulerScheme::needs_stable_step() const {
  if (adaptive()) return std::isfinite(longest_adaptive_step());
  return options_.step.mode == StepMode::stable;
}

void EulerScheme::foresee_stable_step() {
  stable_.reset();
  if (!needs_stable_step()) return;
  try {
    stable_ = stable_step();
  } catch (const RecoverableError&) {  // the step before it remains; the next one reports what stops it
  }
}

double EulerScheme::known_stable_step() {
  const double stable = stable_ ? *stable_ : stable_step();
  if (!(stable > 0))
    throw SolverError(
        fmt::format("{}: the stable step at t = {:.6g} is {}; give a fixed step", name(), time(), stable));
  return stable;
}

double EulerScheme::wanted_step(double t_limit) {
  if (options_.step.mode == StepMode::fixed) return options_.step.length;
  if (options_.step.mode == StepMode::to_limit) return t_limit - time();
  if (adaptive()) return adaptive_step(t_limit);
  const double dt = std::min(options_.step_factor, longest_stable_step()) * known_stable_step();
  if (std::isinf(dt) && std::isinf(t_limit))
    throw SolverError(
        fmt::format("{}: nothing creeps at t = {:.6g} and no end is given; give a fixed step", name(), time()));
  return dt;
}

double EulerScheme::adaptive_step(double t_limit) {
  if (!(proposal_ > 0)) {
    const double latest = latest_first_end(time(), t_limit, options_.end_time);
    const Start start{*this, time(), current_.state, current_.rate, latest, known_stable_step()};
    EulerPoint& work = doubling_->work();
    proposal_ = first_step(system_, doubling_->norm(), start, work.state, work.rate, counters_.convergence_failures);
  }
  return needs_stable_step() ? std::min(proposal_, longest_adaptive_step() * known_stable_step()) : proposal_;
}

double EulerScheme::attempt(const StepClock::Target& target) {
  if (!doubling_) {
    advance(current_, target, next_);
    complete(target.time, next_);
    return 0;
  }
  return doubling_->run(
      time(), current_, target, order(), next_,
      [&](const EulerPoint& from, const StepClock::Target& end, EulerPoint& to) { advance(from, end, to); },
      [&](double t, EulerPoint& to) { complete(t, to); });
}

StepReport EulerScheme::step(double t_limit) {
  if (!(t_limit > time())) throw std::invalid_argument(fmt::format("limit {} is not after t = {}", t_limit, time()));
  double dt = wanted_step(t_limit);
  if (!adaptive()) proposal_ = dt;
  for (int attempts = 1;; ++attempts) {
    const StepClock::Target target = clock_.target(dt, t_limit, adaptive() ? StepClock::stretch : 0);
    std::string reason;
    double factor = 0.5;
    try {
      const double error = attempt(target);
      if (error <= 1) {
        if (adaptive()) propose(dt, target.step, error, attempts > 1);
        accept(target);
        return {.time = time(), .step = target.step, .order = order(), .error_estimate = error};
      }
      ++counters_.rejected_steps;
      factor = StepDoubling::factor(error, order());
      reason = fmt::format(
          "the local error stays {:.2g} times the tolerance: if something jumps there, list that time in "
          "time.breakpoints",
          error);
    } catch (const RecoverableError& error) {
      ++counters_.convergence_failures;
      reason = error.what();
    }
    const double smallest = adaptive() ? smallest_step * std::abs(time()) : 0;
    if (attempts == (adaptive() ? max_adaptive_attempts : max_halvings + 1) || factor * target.step <= smallest ||
        time() + factor * target.step == time())
      give_up(target.step, reason);
    dt = factor * target.step;
  }
}

void EulerScheme::give_up(double shortest, const std::string& reason) {
  const char* advice = adaptive() ? "use a larger tolerance, or cvode_bdf"
                                  : "use a smaller step, or an integrator that controls its step (cvode_bdf)";
  throw SolverError(
      fmt::format("{}: no step is possible from t = {:.6g}, not even one of {:.3g}: {}. The stable step is {:.3g}; {}",
                  name(), time(), shortest, reason, stable_step(), advice));
}

void EulerScheme::propose(double wanted, double made, double error, bool repeated) {
  if (made < wanted) {  // cut by the limit, which says nothing about the step that accuracy allows
    if (repeated) proposal_ = wanted;
  } else {
    const double factor = StepDoubling::factor(error, order());
    proposal_ = made * (repeated ? std::min(factor, 1.0) : factor);
  }
}

void EulerScheme::accept(const StepClock::Target& target) {
  std::swap(previous_, current_);
  std::swap(current_, next_);
  begin_ = time();
  clock_.advance(target);
  last_step_ = target.step;
  ++counters_.steps;
  system_.accept(time(), current_.state);
  if (system_.rate_has_jumped() && current_.load_residual.empty()) try {
      system_.rate(time(), current_.state, current_.rate);
    } catch (const RecoverableError&) {  // the step before it remains, and so does its rate
    }
  if (doubling_) doubling_->set_scale(system_.scale());
  foresee_stable_step();
}

void EulerScheme::fail(const std::string& message) const {
  if (adaptive() || options_.step.mode == StepMode::stable) throw RecoverableError(message);
  throw SolverError(message);
}

void EulerScheme::interpolate(double t, std::span<double> y) const {
  if (t == time()) {
    std::ranges::copy(current_.state, y.begin());
    return;
  }
  require_in_last_step(*this, t, begin_);
  const double theta = (t - begin_) / last_step_;
  for_each_index(y.size(), [&](std::size_t i) {
    const double change = current_.state[i] - previous_.state[i];
    // More would leave the range between both ends: the rate at the start of a step much longer than the stable one.
    const double bend = std::clamp(last_step_ * previous_.rate[i] - change, -std::abs(change), std::abs(change));
    y[i] = previous_.state[i] + theta * (change + (1 - theta) * bend);
  });
}

}  // namespace creepcontact::ode
