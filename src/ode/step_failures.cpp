#include "step_failures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace creepcontact::ode {

namespace {
constexpr int max_attempts = 30;
/// Relative to the time: a method that creeps up to a point with ever smaller steps has failed.
constexpr double smallest_step = 1e-12;
}  // namespace

void fail_at_start(const Integrator& of, double t, const RecoverableError& why) {
  throw SolverError(
      fmt::format("{}: the creep rate cannot be computed at the start, t = {:.6g}: {}", of.name(), t, why.what()));
}

void require_in_last_step(const Integrator& of, double t, double begin) {
  if (!(t >= begin && t < of.time()))
    throw std::out_of_range(fmt::format("{}: t = {} lies outside the last step", of.name(), t));
}

void StepAttempts::begin(double h) const {
  if (h > std::numeric_limits<double>::epsilon() * std::abs(of_.time())) return;
  throw SolverError(fmt::format(
      "{}: no step is possible from t = {:.6g}: steps have shrunk to {:.3g}, because the rates of creep grow "
      "without bound there; check the constants of the creep laws and their units",
      of_.name(), of_.time(), h));
}

void StepAttempts::rejected(double error) {
  ++counters_.rejected_steps;
  if (std::isnan(error)) {
    reason_ = "its rates are not finite numbers; check the constants of the creep laws and their units";
    return;
  }
  reason_ = fmt::format(
      "the local error stays above the tolerance ({:.2g} times) however small the step. Most often a load or "
      "temperature jumps there: list that time in time.breakpoints; otherwise use a larger tolerance",
      error);
}

void StepAttempts::failed(const RecoverableError& why) {
  ++counters_.convergence_failures;
  reason_ = why.what();
}

void StepAttempts::again(double h) {
  if (count_ == max_attempts || h <= smallest_step * std::abs(of_.time()))
    throw SolverError(fmt::format("{}: no step is possible from t = {:.6g}, not even one of {:.3g}: {}", of_.name(),
                                  of_.time(), h, reason_));
  ++count_;
}

}  // namespace creepcontact::ode
