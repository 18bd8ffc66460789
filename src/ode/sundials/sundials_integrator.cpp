#include "sundials_integrator.hpp"

#include <arkode/arkode.h>
#include <cvode/cvode.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "../error_norm.hpp"
#include "../step_failures.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {

namespace {
/// Represents "no stop time": far beyond any time, yet differences to it do not overflow.
constexpr double never = 1e300;
/// Relative to the time: an integrator that creeps up to a point with ever smaller steps has failed.
constexpr double smallest_relative_step = 1e-12;
constexpr int max_retries = 10;
/// A method that has lost its history climbs from order 1 again in about so many steps. With this part of the tolerance
/// they add next to nothing to the error of a run that is resumed often.
constexpr int steps_of_a_start = 10;
constexpr double care = 0.1;

static_assert(CV_TSTOP_RETURN == ARK_TSTOP_RETURN && CV_ERR_FAILURE == ARK_ERR_FAILURE &&
              CV_CONV_FAILURE == ARK_CONV_FAILURE && CV_FIRST_RHSFUNC_ERR == ARK_FIRST_RHSFUNC_ERR &&
              CV_REPTD_RHSFUNC_ERR == ARK_REPTD_RHSFUNC_ERR && CV_UNREC_RHSFUNC_ERR == ARK_UNREC_RHSFUNC_ERR &&
              CV_RHSFUNC_FAIL == ARK_RHSFUNC_FAIL && CV_TOO_MUCH_ACC == ARK_TOO_MUCH_ACC);
}  // namespace

SundialsIntegrator::SundialsIntegrator(std::string name, System& system, const IntegratorOptions& options)
    : options_(options), callbacks_(system), name_(std::move(name)), system_(system) {
  if (!(options.tolerance > 0)) throw ConfigError(fmt::format("tolerance = {}: must be positive", options.tolerance));
  state_ = make_vector(system.team(), system.size(), context_);
  for (Vector* v : {&work_, &weights_}) {
    v->reset(N_VClone(state_.get()));
    if (!*v) throw std::bad_alloc();
  }
  callbacks_.set_weights(weights_.get());
}

void SundialsIntegrator::check(int flag, const char* function) {
  if (flag < 0) throw std::runtime_error(fmt::format("{} failed with flag {}", function, flag));
}

void SundialsIntegrator::initialize(double t, std::span<const double> y, double step) {
  // Methods that begin again at order 1 lose accuracy with every breakpoint.
  careful_steps_ = begun_ && !restores_exactly() ? steps_of_a_start : 0;
  begun_ = true;
  N_VConst(1.0, weights_.get());
  take_weights();
  std::ranges::copy(y, view(state_.get(), y.size()).begin());
  time_ = begin_ = t;
  proposal_ = step;
  begin_anew(step);
}

void SundialsIntegrator::take_weights() {
  const std::span<const double> scale = system_.scale();
  set_error_weights(scale, (careful_steps_ > 0 ? care : 1.0) * options_.tolerance, view(weights_.get(), scale.size()));
}

void SundialsIntegrator::begin_anew(double step) {
  before_ = counters();
  restart(time_, state_.get(), step);
  steps_since_restart_ = 0;
  system_.forget_evaluations();
}

void SundialsIntegrator::restore(const RestartPoint& point) {
  begun_ = true;
  initialize(point.time, point.state, point.next_step);
}

bool SundialsIntegrator::at_restart_point() const {
  return restart_interval() == 0 || steps_since_restart_ == 0 || steps_since_restart_ >= restart_interval();
}

void SundialsIntegrator::limit(double t_limit) {
  if (t_limit < never) {
    check(set_stop(t_limit), "SetStopTime");
    stop_set_ = true;
  } else if (stop_set_) {  // 6.4.1 cannot clear a stop time that an earlier limit has left
    check(set_stop(never), "SetStopTime");
  }
}

double SundialsIntegrator::horizon(double t_limit) const {
  if (options_.end_time > time_ && options_.end_time < t_limit) return options_.end_time;
  if (t_limit < never) return t_limit + (t_limit - time_);  // beyond the stop time, which bounds the search itself
  return time_ + std::max(1.0, std::abs(time_));
}

int SundialsIntegrator::evolve_with_retries(double t_limit, double& t) {
  for (int retries = 0;; ++retries) {
    limit(t_limit);
    check(set_smallest_step(smallest_relative_step * std::abs(time_)), "SetMinStep");
    const int flag = evolve(horizon(t_limit), work_.get(), t);
    callbacks_.rethrow();
    // Explicit Runge-Kutta methods of ARKODE take a recoverable failure within a step for a fatal one.
    const double failed = statistics().next_step;
    const double retry = 0.25 * failed;
    if (flag != ARK_UNREC_RHSFUNC_ERR || retries == max_retries || !(retry > smallest_relative_step * std::abs(time_)))
      return flag;
    before_ = counters();
    restart(time_, state_.get(), retry);
  }
}

StepReport SundialsIntegrator::step(double t_limit) {
  if (!(t_limit > time_)) throw std::invalid_argument(fmt::format("limit {} is not after t = {}", t_limit, time_));
  StepReport report;
  // Not right after the step before: interpolate() has needed the memory until now.
  if (restart_interval() > 0 && (steps_since_restart_ >= restart_interval() || rate_has_jumped_)) begin_anew(proposal_);
  // Too close for arithmetic on the time: the library would not step either.
  const double rounding = 100 * std::numeric_limits<double>::epsilon() * std::abs(time_);
  if (t_limit - internal_time() <= rounding) {
    report = {.time = t_limit, .step = t_limit - time_, .order = statistics().order, .error_estimate = 0};
    time_ = t_limit;
    ++steps_since_restart_;
    system_.accept(time_, state());
    return report;
  }

  callbacks_.clear();
  double t = time_;
  const int flag = evolve_with_retries(t_limit, t);
  if (flag < 0) throw SolverError(advice(flag));

  const bool stopped = flag == CV_TSTOP_RETURN;
  begin_ = std::exchange(time_, stopped ? t_limit : t);
  std::swap(state_, work_);
  if (stopped) stop_set_ = false;

  const Statistics now = statistics();
  // A step cut by the limit says nothing about the step that accuracy allows: the earlier proposal remains.
  const bool cut = stopped || time_ + now.next_step >= t_limit * (1 - 1e-14);
  proposal_ = cut ? std::max(proposal_, time_ - begin_) : now.next_step;

  check(local_errors(work_.get()), "GetEstLocalErrors");
  report = {.time = time_,
            .step = time_ - begin_,
            .order = now.order,
            .error_estimate = (careful_steps_ > 0 ? care : 1.0) * N_VWrmsNorm(work_.get(), weights_.get())};
  ++steps_since_restart_;
  if (careful_steps_ > 0) --careful_steps_;
  system_.accept(time_, state());
  rate_has_jumped_ = system_.rate_has_jumped();
  take_weights();
  return report;
}

void SundialsIntegrator::interpolate(double t, std::span<double> y) const {
  if (t == time_) {
    std::ranges::copy(state(), y.begin());
    return;
  }
  require_in_last_step(*this, t, begin_);
  check(interpolate_into(t, work_.get()), "GetDky");
  std::ranges::copy(view(work_.get(), y.size()), y.begin());
}

Integrator::Counters SundialsIntegrator::counters() const {
  const Statistics now = statistics();
  return {.steps = before_.steps + now.steps,
          .rejected_steps = before_.rejected_steps + now.rejected,
          .convergence_failures = before_.convergence_failures + now.convergence_failures};
}

std::string SundialsIntegrator::advice(int flag) const {
  const char* text = "";
  switch (flag) {
    case CV_ERR_FAILURE:
      text =
          "the local error stays above the tolerance however small the step. Most often a load or temperature jumps "
          "there: list that time in time.breakpoints; otherwise use a larger tolerance";
      break;
    case CV_CONV_FAILURE:
      text =
          "the iterations for the implicit step do not converge however small the step. Tighten the tolerance of the "
          "contact solver (it must be well below that of the integrator), or try another integrator";
      break;
    case CV_FIRST_RHSFUNC_ERR:
    case CV_RHSFUNC_FAIL:
    case CV_UNREC_RHSFUNC_ERR:
      text = "the creep rate cannot be evaluated at this state: the equilibrium or the contact has no solution here";
      break;
    case CV_REPTD_RHSFUNC_ERR:
      text = "the creep rate cannot be evaluated beyond this time however small the step";
      break;
    case CV_TOO_MUCH_ACC:
      text = "the tolerance is below the rounding error of the state: use a larger one";
      break;
    default:
      text = "the integrator failed";
  }
  return fmt::format("{}: no step is possible from t = {:.6g}: {}.{}", name_, time_, text, callbacks_.details());
}

}  // namespace creepcontact::ode
