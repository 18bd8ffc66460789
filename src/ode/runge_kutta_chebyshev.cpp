#include "runge_kutta_chebyshev.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "elementwise.hpp"
#include "first_step.hpp"
#include "step_failures.hpp"

namespace creepcontact::ode {

namespace {
/// The radius may grow in the course of the step; a tenth more costs a twentieth more stages.
constexpr double radius_safety = 1.1;
/// 13000 stable steps of explicit Euler in one. What more stages save is little against what a rejected step loses,
/// and the rounding errors of the recursion grow with their square.
constexpr int max_stages = 200;
constexpr double step_safety = 0.8;
constexpr double largest_growth = 10, largest_cut = 0.1;
constexpr double failure_cut = 0.25;
constexpr double tiny_error = 1e-10;  // grows no further than a larger one would
}  // namespace

RungeKuttaChebyshev::RungeKuttaChebyshev(System& system, const IntegratorOptions& options)
    : system_(system), options_(options), norm_(system.team(), options.tolerance) {
  for (auto* vector : {&state_, &rate_, &newer_, &older_, &stage_rate_, &previous_, &previous_rate_})
    vector->resize(system.size());
}

void RungeKuttaChebyshev::initialize(double t, std::span<const double> y, double step) {
  norm_.set_scale(system_.scale());
  clock_.start(t);
  std::ranges::copy(y, state_.begin());
  begin_ = t;
  proposal_ = step;
  controlled_step_ = controlled_error_ = 0;
  at_start(*this, t, [&] {
    system_.rate(t, state_, rate_);
    radius_ = radius(t, state_);
  });
}

RestartPoint RungeKuttaChebyshev::save() const {
  RestartPoint point = Integrator::save();
  point.memory.save("", *this, saved_members);
  point.memory.save("lost_time", clock_.lost());
  point.states["rate"] = rate_;
  return point;
}

void RungeKuttaChebyshev::restore(const RestartPoint& point) {
  rate_ = point.states.at("rate");
  point.memory.restore("", *this, saved_members);
  clock_.start(point.time, point.memory.at("lost_time").at(0));
  norm_.set_scale(system_.scale());
  state_ = point.state;
  begin_ = point.time;
  proposal_ = point.next_step;
  system_.forget_evaluations();
}

double RungeKuttaChebyshev::radius(double t, std::span<const double> y) {
  const double stable = system_.stable_step(t, y);
  if (!(stable > 0)) throw RecoverableError(fmt::format("the stable step of explicit Euler is {}", stable));
  return 2 * radius_safety / stable;
}

double RungeKuttaChebyshev::first_step(double t_limit) {
  const Start start{*this, time(), state_, rate_, latest_first_end(time(), t_limit, options_.end_time), 2 / radius_};
  return ode::first_step(system_, norm_, start, newer_, stage_rate_, counters_.convergence_failures);
}

StepReport RungeKuttaChebyshev::step(double t_limit) {
  if (!(t_limit > time())) throw std::invalid_argument(fmt::format("limit {} is not after t = {}", t_limit, time()));
  if (!(proposal_ > 0)) proposal_ = first_step(t_limit);
  double h = proposal_;
  StepAttempts attempts(*this, counters_);
  attempts.begin(h);
  for (;; attempts.again(h)) {
    if (radius_ > 0) h = std::min(h, chebyshev_stability_bound(max_stages) / radius_);
    const StepClock::Target target = clock_.target(h, t_limit, StepClock::stretch);
    try {
      run_stages(target);
      const double error = local_error(target.step);
      if (error <= 1) {
        const double next_radius = radius(target.time, newer_);
        const bool cut = target.step < h;  // by the limit: says nothing about the step that accuracy allows
        accept(target);
        proposal_ = cut ? h : next_step_after(target.step, error, attempts.count() > 1);
        radius_ = next_radius;
        return {.time = time(), .step = target.step, .order = 2, .error_estimate = error};
      }
      attempts.rejected(error);
      // An error that is not a number fails the comparison, too.
      h = target.step * (error < 1e9 ? std::max(largest_cut, step_safety / std::cbrt(error)) : largest_cut);
    } catch (const RecoverableError& failure) {
      attempts.failed(failure);
      h = failure_cut * target.step;
    }
  }
}

void RungeKuttaChebyshev::run_stages(const StepClock::Target& target) {
  const double h = target.step;
  const std::size_t count = chebyshev_stage_count(h * radius_);
  if (stages_.size() != count) stages_ = chebyshev_stages(static_cast<int>(count));
  const double first = h * stages_[0].mu_rate;
  for_each_index(state_.size(), [&](std::size_t i) { newer_[i] = state_[i] + first * rate_[i]; });
  const std::vector<double>* before = &state_;  // Y_{j-2}, overwritten by Y_j from the third stage on
  for (std::size_t j = 1; j < count; ++j) {
    system_.rate(time() + stages_[j - 1].c * h, newer_, stage_rate_);
    const double mu = stages_[j].mu, nu = stages_[j].nu, own = 1 - mu - nu;
    const double new_part = h * stages_[j].mu_rate;
    const double old_part = h * stages_[j].gamma_rate;
    for_each_index(state_.size(), [&](std::size_t i) {
      older_[i] =
          own * state_[i] + mu * newer_[i] + nu * (*before)[i] + new_part * stage_rate_[i] + old_part * rate_[i];
    });
    std::swap(newer_, older_);
    before = &older_;
  }
  system_.rate(target.time, newer_, stage_rate_);
}

double RungeKuttaChebyshev::local_error(double h) const {
  return norm_([&](std::size_t begin, std::size_t n) {
    return 0.8 * (piece(state_.data(), begin, n) - piece(newer_.data(), begin, n)) +
           0.4 * h * (piece(rate_.data(), begin, n) + piece(stage_rate_.data(), begin, n));
  });
}

void RungeKuttaChebyshev::accept(const StepClock::Target& target) {
  std::swap(previous_, state_);
  std::swap(previous_rate_, rate_);
  std::swap(state_, newer_);
  std::swap(rate_, stage_rate_);
  begin_ = time();
  clock_.advance(target);
  last_step_ = target.step;
  ++counters_.steps;
  system_.accept(time(), state_);
  if (system_.rate_has_jumped()) try {
      system_.rate(time(), state_, rate_);
    } catch (const RecoverableError&) {  // the step before it remains, and so does its rate
    }
  norm_.set_scale(system_.scale());
}

/// The trend of the last two steps goes on, but a step made shorter is not followed by a longer one.
double RungeKuttaChebyshev::next_step_after(double h, double error, bool repeated) {
  const double bounded = std::max(error, tiny_error);
  double factor = step_safety / std::cbrt(bounded);
  if (controlled_step_ > 0) factor *= std::cbrt(controlled_error_ / bounded) * h / controlled_step_;
  controlled_step_ = h;
  controlled_error_ = bounded;
  return h * std::clamp(factor, largest_cut, repeated ? 1.0 : largest_growth);
}

void RungeKuttaChebyshev::interpolate(double t, std::span<double> y) const {
  if (t == time()) {
    std::ranges::copy(state_, y.begin());
    return;
  }
  require_in_last_step(*this, t, begin_);
  const double x = (t - begin_) / last_step_;
  const double to_end = x * x * (3 - 2 * x);
  const double old_slope = last_step_ * x * (1 - x) * (1 - x);
  const double new_slope = -last_step_ * x * x * (1 - x);
  for_each_index(y.size(), [&](std::size_t i) {
    y[i] = previous_[i] + to_end * (state_[i] - previous_[i]) + old_slope * previous_rate_[i] + new_slope * rate_[i];
  });
}

}  // namespace creepcontact::ode
