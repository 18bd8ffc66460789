#include "euler_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "elementwise.hpp"

namespace creepcontact::ode {

namespace {
constexpr int max_halvings = 10;
}

EulerScheme::EulerScheme(System& system, const IntegratorOptions& options) : system_(system), options_(options) {
  if (!(options.step >= 0) || !std::isfinite(options.step))
    throw ConfigError(fmt::format("step = {}: must be positive, or 0 for the stable step", options.step));
  if (!(options.step_factor > 0))
    throw ConfigError(fmt::format("step_factor = {}: must be positive", options.step_factor));
  for (auto* vector : {&state_, &rate_, &candidate_, &candidate_rate_, &previous_, &previous_rate_})
    vector->resize(system.size());
}

void EulerScheme::initialize(double t, std::span<const double> y, double) {
  clock_.start(t);
  std::ranges::copy(y, state_.begin());
  std::ranges::copy(y, previous_.begin());
  begin_ = t;
  last_step_ = 0;
  proposal_ = options_.step;
  stable_.reset();
  system_.forget_evaluations();
  try {
    system_.rate(t, state_, rate_);
  } catch (const RecoverableError& error) {
    throw SolverError(fmt::format("{}: no rate at the start, t = {:.6g}: {}", name(), t, error.what()));
  }
}

RestartPoint EulerScheme::save() const {
  RestartPoint point = Integrator::save();
  point.memory["lost_time"] = {clock_.lost()};
  point.memory["rate"] = rate_;
  if (stable_) point.memory["stable_step"] = {*stable_};
  return point;
}

void EulerScheme::restore(const RestartPoint& point) {
  rate_ = point.memory.at("rate");
  clock_.start(point.time, point.memory.at("lost_time").at(0));
  state_ = previous_ = point.state;
  begin_ = point.time;
  last_step_ = 0;
  proposal_ = point.next_step;
  stable_.reset();
  if (point.memory.contains("stable_step")) stable_ = point.memory.at("stable_step").at(0);
  system_.forget_evaluations();
}

void EulerScheme::foresee_stable_step() {
  stable_.reset();
  if (options_.step > 0) return;
  try {
    stable_ = stable_step();
  } catch (const RecoverableError&) {  // the step before it stands; the next one reports what stops it
  }
}

double EulerScheme::wanted_step(double t_limit) {
  if (options_.step > 0) return options_.step;
  const double dt = options_.step_factor * (stable_ ? *stable_ : stable_step());
  if (!(dt > 0))
    throw SolverError(fmt::format("{}: the stable step at t = {:.6g} is {}; give a fixed step", name(), time(), dt));
  if (std::isinf(dt) && std::isinf(t_limit))
    throw SolverError(
        fmt::format("{}: nothing creeps at t = {:.6g} and no end is given: give a fixed step", name(), time()));
  return dt;
}

StepReport EulerScheme::step(double t_limit) {
  if (!(t_limit > time())) throw std::invalid_argument(fmt::format("limit {} is not after t = {}", t_limit, time()));
  const double wanted = wanted_step(t_limit);
  double dt = wanted;
  for (int halvings = 0;; ++halvings) {
    const StepClock::Target target = clock_.target(dt, t_limit);
    try {
      attempt(target);
    } catch (const RecoverableError& error) {
      ++counters_.convergence_failures;
      if (halvings == max_halvings || time() + 0.5 * target.step == time())
        throw SolverError(fmt::format(
            "{}: no step from t = {:.6g}, not even one of {:.3g}: {}. The stable step is {:.3g}; take a smaller step, "
            "or an integrator that controls it (cvode_bdf)",
            name(), time(), target.step, error.what(), stable_step()));
      dt = 0.5 * target.step;
      continue;
    }
    accepted();
    std::swap(previous_, state_);
    std::swap(state_, candidate_);
    std::swap(previous_rate_, rate_);
    std::swap(rate_, candidate_rate_);
    begin_ = time();
    clock_.advance(target);
    last_step_ = target.step;
    proposal_ = wanted;
    ++counters_.steps;
    system_.accept(time(), state_);
    foresee_stable_step();
    return {.time = time(), .step = target.step, .order = order(), .error_estimate = 0};
  }
}

void EulerScheme::interpolate(double t, std::span<double> y) const {
  if (t == time()) {
    std::ranges::copy(state_, y.begin());
    return;
  }
  if (!(t >= begin_ && t < time()))
    throw std::out_of_range(fmt::format("{}: t = {} lies outside the last step", name(), t));
  const double theta = (t - begin_) / last_step_;
  const double slope = theta * (1 - theta) * last_step_;
  for_each_index(y.size(), [&](std::size_t i) {
    y[i] = previous_[i] + slope * previous_rate_[i] + theta * theta * (state_[i] - previous_[i]);
  });
}

}  // namespace creepcontact::ode
