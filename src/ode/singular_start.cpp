#include "singular_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "elementwise.hpp"
#include "error_norm.hpp"

namespace creepcontact::ode {
namespace {

constexpr double first_try = 1e-3;         // of the time to the limit
constexpr double wanted_strain = 0.5;      // in errors that a step may make; the increment may give up to 1
constexpr double max_stress_change = 0.1;  // by loads in the increment, as strain of it, in the same unit
constexpr int max_start_attempts = 60;
const std::string start_name = "start";

/// The start that a restart point goes on from.
struct SavedStart {
  double time = 0, exponent = 1;
  double transformed_time = 0;  // of the inner integrator, at the restart point
  static constexpr auto members =
      std::tuple{Member{"time", &SavedStart::time}, Member{"exponent", &SavedStart::exponent},
                 Member{"transformed_time", &SavedStart::transformed_time}};
};

IntegratorOptions options_in_s(IntegratorOptions options) {
  options.end_time = 0;  // a time, and the limits of the steps come from here
  if (options.step.mode == StepMode::fixed) options.step = StepMode::to_limit;
  return options;
}

}  // namespace

SingularStart::SingularStart(const IntegratorInfo& method, System& system, const IntegratorOptions& options)
    : system_(system),
      started_(system),
      options_(options),
      inner_(method.make(started_, options_in_s(options))),
      change_(system.size()) {}

void SingularStart::initialize(double t, std::span<const double> y, double step) {
  begun_ = false;
  time_ = t;
  proposal_ = step;
  start_.assign(y.begin(), y.end());
}

double SingularStart::increment_size(double stress_time, double duration) {
  std::ranges::fill(change_, 0.0);
  system_.singular_rate()->start_increment(time_, start_, stress_time, duration, change_);
  ErrorNorm norm(system_.team(), options_.tolerance);
  norm.set_scale(system_.scale());
  return norm([&](std::size_t begin, std::size_t n) { return piece(std::as_const(change_).data(), begin, n); });
}

double SingularStart::free_increment(double longest) {
  double duration = first_try * longest;
  for (int attempt = 0;; ++attempt) {
    const double later = increment_size(time_ + duration, duration);
    const double size = increment_size(time_, duration);
    if (size <= 1 && later - size <= max_stress_change) return duration;
    if (attempt == max_start_attempts || !std::isfinite(size + later))
      throw SolverError(fmt::format(
          "{}: the first increment from t = {:.6g} failed: the creep strain grows without bound", name(), time_));
    const double largest = std::max(size, later);
    duration *= std::clamp(std::pow(wanted_strain / largest, 1 / started_.exponent()), 1e-12, 0.5);
  }
}

bool SingularStart::has_fixed_steps() const {
  return options_.step.mode == StepMode::fixed && name().ends_with("_euler");
}

void SingularStart::begin(double t_limit) {
  const double exponent = system_.singular_rate()->start_exponent(time_, start_);
  started_.start(time_, std::min(exponent, 1.0));
  if (!(exponent < 1)) {
    first_ = 0;
    inner_->initialize(time_, start_, proposal_);
    begun_ = true;
    return;
  }
  if (has_fixed_steps()) {
    first_ = std::min(options_.step.length, t_limit - time_);
    increment_size(time_, first_);
  } else {
    first_ = free_increment(t_limit - time_);
  }
  std::vector<double> state = start_;
  for_each_index(state.size(), [&](std::size_t i) { state[i] += change_[i]; });
  inner_->initialize(std::pow(first_, exponent), state);
  begun_ = true;
}

StepReport SingularStart::step(double t_limit) {
  const double from = time_;
  try {
    const bool starts = !begun_;
    if (starts) begin(t_limit);
    if (starts && first_ > 0 && has_fixed_steps()) {
      time_ = from + first_ >= t_limit ? t_limit : from + first_;
      ++own_steps_;
      system_.accept(time_, inner_->state());
      return {.time = time_, .step = time_ - from, .order = 1, .error_estimate = 0};
    }
    const double end = has_fixed_steps() ? std::min(t_limit, from + options_.step.length) : t_limit;
    started_.set_limit(end);
    s_begin_ = inner_->time();
    StepReport report = inner_->step(started_.s_limit());
    time_ = inner_->time() == started_.s_limit() ? end : started_.t(inner_->time());
    report.time = time_;
    report.step = time_ - from;
    return report;
  } catch (const RecoverableError& error) {
    throw SolverError(fmt::format("{}: the first increment from t = {:.6g} failed: {}", name(), from, error.what()));
  } catch (const SolverError& error) {
    if (started_.exponent() == 1 || !begun_) throw;
    throw SolverError(fmt::format("{} (at t = {:.6g}; times in this message are values of (t - {:.6g})^{:.3g})",
                                  error.what(), from, started_.begin(), started_.exponent()));
  }
}

void SingularStart::interpolate(double t, std::span<double> y) const {
  if (t == time_) {
    std::ranges::copy(state(), y.begin());
    return;
  }
  const double s = started_.s(t);
  const double first = std::pow(first_, started_.exponent());
  if (first_ == 0 || s >= first) {
    inner_->interpolate(std::clamp(s, s_begin_, inner_->time()), y);
    return;
  }
  // Within the first increment, which is linear in s.
  for_each_index(y.size(), [&](std::size_t i) { y[i] = start_[i] + s / first * change_[i]; });
}

double SingularStart::next_step() const {
  if (!begun_) return proposal_;
  return started_.t(inner_->time() + inner_->next_step()) - time_;
}

RestartPoint SingularStart::save() const {
  if (!begun_) return Integrator::save();
  RestartPoint point = inner_->save();
  point.memory.save(start_name, SavedStart{started_.begin(), started_.exponent(), point.time});
  point.time = time_;
  return point;
}

void SingularStart::restore(const RestartPoint& point) {
  initialize(point.time, point.state, point.next_step);
  if (point.memory.part(start_name).empty()) return;
  SavedStart start;
  point.memory.restore(start_name, start);
  started_.start(start.time, start.exponent);
  RestartPoint inner = point;
  inner.time = start.transformed_time;
  inner_->restore(inner);
  s_begin_ = inner_->time();
  first_ = 0;
  begun_ = true;
}

Integrator::Counters SingularStart::counters() const {
  Counters all = inner_->counters();
  all.steps += own_steps_;
  return all;
}

}  // namespace creepcontact::ode
