#include "beta_euler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "elementwise.hpp"

namespace creepcontact::ode {

namespace {
/// Beyond this growth over the smallest change so far the iterations are taken to diverge; a transient of a
/// nonlinear law grows less.
constexpr double divergence_factor = 1e3;
}  // namespace

BetaEuler::BetaEuler(System& system, const IntegratorOptions& options)
    : EulerScheme(system, options),
      load_strain_(system.size(), options.residual_correction),
      load_(system.size()),
      iterate_(system.size()) {
  if (!(options.beta >= 0.5 && options.beta <= 1))
    throw ConfigError(
        fmt::format("beta = {}: must lie between 0.5 and 1 (below 0.5 the scheme is unstable; for 0 take "
                    "explicit_euler)",
                    options.beta));
  if (!(options.inner_tolerance > 0))
    throw ConfigError(fmt::format("inner_tolerance = {}: must be positive", options.inner_tolerance));
  if (options.max_inner_iterations < 1)
    throw ConfigError(fmt::format("max_inner_iterations = {}: must be at least 1", options.max_inner_iterations));
  if (!(options.residual_correction >= 0 && options.residual_correction <= 1))
    throw ConfigError(fmt::format("residual_correction = {}: must lie between 0 and 1", options.residual_correction));
}

void BetaEuler::initialize(double t, std::span<const double> y, double step) {
  EulerScheme::initialize(t, y, step);
  load_strain_.reset();
}

void BetaEuler::attempt(const StepClock::Target& target) {
  const double dt = target.step;
  const double old_part = dt * (1 - options_.beta);
  const double new_part = dt * options_.beta;
  const std::size_t n = state_.size();

  for_each_index(n, [&](std::size_t i) { candidate_[i] = state_[i] + dt * rate_[i]; });
  double smallest = std::numeric_limits<double>::infinity();
  for (int iteration = 1; iteration <= options_.max_inner_iterations; ++iteration) {
    load_strain_.load(candidate_, load_);
    system_.rate(target.time, load_, candidate_rate_);
    for_each_index(
        n, [&](std::size_t i) { iterate_[i] = state_[i] + old_part * rate_[i] + new_part * candidate_rate_[i]; });
    const double change = max_difference(iterate_, candidate_);
    std::swap(candidate_, iterate_);
    if (change <= options_.inner_tolerance) return;
    if (!std::isfinite(change) || change > divergence_factor * smallest) give_up("diverge", dt, iteration, change);
    smallest = std::min(smallest, change);
    if (iteration == options_.max_inner_iterations) give_up("do not converge", dt, iteration, change);
  }
}

void BetaEuler::give_up(const char* what, double dt, int iterations, double change) {
  const double stable = stable_step();
  throw SolverError(fmt::format(
      "beta_euler: the inner iterations {} in the step of {:.3g} from t = {:.6g} (change {:.2g} after {} iterations, "
      "inner_tolerance {:.2g}). The stable step of explicit Euler is {:.3g} there, and the iterations contract only "
      "for steps below stable / (2 beta) = {:.3g}: take a smaller step, beta = 0.5, or cvode_bdf",
      what, dt, time(), change, iterations, options_.inner_tolerance, stable, stable / (2 * options_.beta)));
}

}  // namespace creepcontact::ode
