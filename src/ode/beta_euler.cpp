#include "beta_euler.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "elementwise.hpp"

namespace creepcontact::ode {
namespace {

/// The solution of a relaxing system lies no further from y than G(y) - y is long. An iterate farther from the last
/// image than this many changes comes of residuals that depend on each other, where the least-squares problem has no
/// solution of its own: points of equal stress, say, which differ by nothing or by rounding.
constexpr double trust_factor = 10;

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
  if (options.inner_anderson < 0)
    throw ConfigError(
        fmt::format("inner_anderson = {}: must be at least 0 (0: plain iterations)", options.inner_anderson));
  if (!(options.residual_correction >= 0 && options.residual_correction <= 1))
    throw ConfigError(fmt::format("residual_correction = {}: must lie between 0 and 1", options.residual_correction));
  if (options.inner_anderson > 0)
    anderson_ = std::make_unique<AndersonIteration>(system.size(), options.inner_anderson, trust_factor);
}

void BetaEuler::initialize(double t, std::span<const double> y, double step) {
  EulerScheme::initialize(t, y, step);
  load_strain_.reset();
}

RestartPoint BetaEuler::save() const {
  RestartPoint point = EulerScheme::save();
  point.memory["load_residual"] = load_strain_.residual();
  return point;
}

void BetaEuler::restore(const RestartPoint& point) {
  EulerScheme::restore(point);
  load_strain_.restore(point.memory.at("load_residual"));
}

void BetaEuler::attempt(const StepClock::Target& target) {
  target_ = target;
  for_each_index(state_.size(), [&](std::size_t i) { candidate_[i] = state_[i] + target.step * rate_[i]; });
  ConvergenceWatch watch(options_.inner_tolerance, options_.max_inner_iterations);
  if (anderson_)
    anderson_->run(candidate_, [&](std::span<const double> y, std::span<double> image) {
      map(y, image);
      return watch.see(max_difference(image, y)) != ConvergenceWatch::State::running;
    });
  else
    iterate_plainly(watch);
  if (watch.state() != ConvergenceWatch::State::converged) give_up(watch);
}

void BetaEuler::map(std::span<const double> y, std::span<double> image) {
  const double old_part = target_.step * (1 - options_.beta);
  const double new_part = target_.step * options_.beta;
  load_strain_.load(y, load_);
  system_.rate(target_.time, load_, candidate_rate_);
  for_each_index(y.size(),
                 [&](std::size_t i) { image[i] = state_[i] + old_part * rate_[i] + new_part * candidate_rate_[i]; });
}

void BetaEuler::iterate_plainly(ConvergenceWatch& watch) {
  do {
    map(candidate_, iterate_);
    watch.see(max_difference(iterate_, candidate_));
    std::swap(candidate_, iterate_);
  } while (watch.state() == ConvergenceWatch::State::running);
}

void BetaEuler::give_up(const ConvergenceWatch& watch) {
  const double stable = stable_step();
  const char* what = watch.state() == ConvergenceWatch::State::diverging ? "diverge" : "do not converge";
  const std::string advice = anderson_
                                 ? fmt::format(" (inner_anderson = {} carries some times as far): take a smaller step",
                                               options_.inner_anderson)
                                 : ": take a smaller step, accelerated iterations (inner_anderson = 3)";
  throw SolverError(fmt::format(
      "beta_euler: the inner iterations {} in the step of {:.3g} from t = {:.6g} (change {:.2g} after {} iterations, "
      "inner_tolerance {:.2g}). The stable step of explicit Euler is {:.3g} there, and plain iterations contract only "
      "for steps below stable / (2 beta) = {:.3g}{}, beta = 0.5, or cvode_bdf",
      what, target_.step, time(), watch.change(), watch.iterations(), options_.inner_tolerance, stable,
      stable / (2 * options_.beta), advice));
}

}  // namespace creepcontact::ode
