#include "beta_euler.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>

#include "../elementwise.hpp"
#include "../state_norms.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {
namespace {

/// The solution of a relaxing system lies no further from y than G(y) - y is long. An iterate farther from the last
/// image than this many changes results from residuals that depend on each other, where the least-squares problem has
/// no solution of its own: points of equal stress, say, which differ by nothing or by rounding.
constexpr double trust_factor = 10;
/// Adaptive steps: contraction of the plain iterations in the whole step. Longer steps take more iterations than they
/// save steps (e^-1 would be the best), and the accelerated ones go twice as far.
constexpr double adaptive_contraction = 0.5;
constexpr double stable_contraction = 0.8;  // with step = "stable", which asks for long steps
constexpr double anderson_gain = 2;

}  // namespace

BetaEuler::BetaEuler(System& system, const IntegratorOptions& options)
    : EulerScheme(system, options, system.size()),
      residual_correction_(options.residual_correction),
      load_(system.size()),
      load_rate_(system.size()),
      iterate_(system.size()) {
  if (!(options.beta >= 0.5 && options.beta <= 1))
    throw ConfigError(fmt::format(
        "beta = {}: must lie between 0.5 and 1 (below 0.5 the scheme is unstable; for 0 use explicit_euler)",
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
  if (options.inner_anderson > 0 && options.inner == InnerIteration::newton)
    throw ConfigError(fmt::format(
        "inner_anderson = {}: is for inner = \"fixed_point\" only; remove it, or set it to 0, with \"newton\"",
        options.inner_anderson));
  if (options.inner_anderson > 0)
    anderson_ = std::make_unique<AndersonIteration>(system.size(), options.inner_anderson, trust_factor, system.team());
  if (options.inner == InnerIteration::newton) newton_ = std::make_unique<NewtonIteration>(system);
}

double BetaEuler::longest_adaptive_step() const {
  return step_that_contracts_by(adaptive_contraction);
}

double BetaEuler::longest_stable_step() const {
  return step_that_contracts_by(stable_contraction);
}

double BetaEuler::step_that_contracts_by(double factor) const {
  if (newton_) return std::numeric_limits<double>::infinity();
  return factor * (anderson_ ? anderson_gain : 1) / (2 * options_.beta);
}

void BetaEuler::advance(const EulerPoint& from, const StepClock::Target& target, EulerPoint& to) {
  from_ = &from;
  target_ = target;
  for_each_index(from.state.size(), [&](std::size_t i) { to.state[i] = from.state[i] + target.step * from.rate[i]; });
  ConvergenceWatch watch(options_.inner_tolerance, options_.max_inner_iterations);
  if (newton_)
    iterate_by_newton(to, watch);
  else if (anderson_)
    anderson_->run(to.state, [&](std::span<const double> y, std::span<double> image) {
      map(y, image);
      return watch.update(max_difference(system_.team(), image, y)) != ConvergenceWatch::State::running;
    });
  else
    iterate_plainly(to.state, watch);
  if (watch.state() != ConvergenceWatch::State::converged) give_up(watch);
  if (!newton_) std::ranges::copy(load_rate_, to.rate.begin());
  ResidualCorrection::residual(to.state, load_, to.load_residual);
}

void BetaEuler::map(std::span<const double> y, std::span<double> image) {
  const double old_part = target_.step * (1 - options_.beta);
  const double new_part = target_.step * options_.beta;
  residual_correction_.load(y, from_->load_residual, load_);
  system_.rate(target_.time, load_, load_rate_);
  for_each_index(y.size(), [&](std::size_t i) {
    image[i] = from_->state[i] + old_part * from_->rate[i] + new_part * load_rate_[i];
  });
}

void BetaEuler::iterate_plainly(std::vector<double>& y, ConvergenceWatch& watch) {
  do {
    map(y, iterate_);
    watch.update(max_difference(system_.team(), iterate_, y));
    std::swap(y, iterate_);
  } while (watch.state() == ConvergenceWatch::State::running);
}

/// An explicit step is a good guess unless it passes the solution by more than its own length: long steps do.
bool BetaEuler::good_guess(std::span<const double> y) {
  try {
    map(y, iterate_);
  } catch (const RecoverableError&) {
    return false;
  }
  return max_difference(system_.team(), iterate_, y) <= max_difference(system_.team(), y, from_->state);
}

void BetaEuler::iterate_by_newton(EulerPoint& to, ConvergenceWatch& watch) {
  if (!good_guess(to.state)) {
    std::ranges::copy(from_->state, to.state.begin());
    map(to.state, iterate_);
  }
  const NewtonIteration::Equation equation{target_.time, target_.step * options_.beta,
                                           [&](std::span<const double> y, std::span<double> image) { map(y, image); },
                                           load_, load_rate_};
  newton_->run(equation, to.state, iterate_, to.rate, watch);
}

void BetaEuler::give_up(const ConvergenceWatch& watch) {
  if (newton_)
    throw RecoverableError(
        fmt::format("the Newton iterations do not converge: change {:.2g} after {} iterations, inner_tolerance {:.2g}",
                    watch.change(), watch.iterations(), options_.inner_tolerance));
  const double stable = stable_step();
  const char* what = watch.state() == ConvergenceWatch::State::diverging ? "diverge" : "do not converge";
  const std::string advice =
      anderson_ ? fmt::format(" (inner_anderson = {} allows a few times longer steps): use a smaller step",
                              options_.inner_anderson)
                : ": use a smaller step, inner = \"newton\", accelerated iterations (inner_anderson = 3)";
  fail(
      fmt::format("beta_euler: the inner iterations {} in the step of {:.3g} from t = {:.6g} (change {:.2g} after {} "
                  "iterations, inner_tolerance {:.2g}). The stable step of explicit Euler is {:.3g} there, and plain "
                  "iterations converge only for steps below stable / (2 beta) = {:.3g}{}, beta = 0.5, or cvode_bdf",
                  what, target_.step, time(), watch.change(), watch.iterations(), options_.inner_tolerance, stable,
                  stable / (2 * options_.beta), advice));
}

}  // namespace creepcontact::ode
