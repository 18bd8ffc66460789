#include "isochronous.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "convergence_watch.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {
namespace {

constexpr double residual = 1e-3;  // of the tolerance
constexpr int max_iterations = 50;
constexpr int max_step_halvings = 30;

}  // namespace

Isochronous::Isochronous(System& system, const IntegratorOptions& options)
    : system_(system),
      tolerance_(options.tolerance),
      newton_(system),
      state_(system.size()),
      next_(system.size()),
      image_(system.size()),
      rate_(system.size()),
      point_(system.size()) {}

void Isochronous::initialize(double t, std::span<const double> y, double /*step*/) {
  time_ = t;
  std::ranges::copy(y, state_.begin());
  system_.forget_evaluations();
  try {
    solve(t);
  } catch (const RecoverableError& error) {
    throw SolverError(fmt::format("isochronous: no equilibrium at t = {:.6g}: {}", t, error.what()));
  }
  std::swap(state_, next_);
  system_.accept(t, state_);
}

void Isochronous::solve(double t) {
  const std::span<const double> scale = system_.scale();
  const double own = scale.empty() ? 1 : *std::min_element(scale.begin(), scale.end());
  const double smallest = system_.team().min(own);
  ConvergenceWatch watch(residual * tolerance_ * smallest, max_iterations);
  const auto evaluate = [&](std::span<const double> y, std::span<double> image) {
    system_.rate(t, y, image);
    std::ranges::copy(y, point_.begin());
    std::ranges::copy(image, rate_.begin());
  };
  next_ = state_;
  evaluate(next_, image_);
  std::vector<double> last_rate(next_.size());
  newton_.run({t, 1.0, evaluate, point_, rate_}, next_, image_, last_rate, watch);
  if (watch.state() != ConvergenceWatch::State::converged)
    throw RecoverableError(
        fmt::format("Newton's iterations do not converge: change of the creep strain {:.2g} after {} iterations",
                    watch.change(), watch.iterations()));
}

StepReport Isochronous::step(double t_limit) {
  if (!(t_limit > time_)) throw std::invalid_argument(fmt::format("limit {} is not after t = {}", t_limit, time_));
  double target = t_limit;
  for (int halvings = 0;; ++halvings) {
    try {
      solve(target);
      break;
    } catch (const RecoverableError& error) {
      ++counters_.convergence_failures;
      const double middle = time_ + 0.25 * (target - time_);
      if (halvings == max_step_halvings || !(middle > time_))
        throw SolverError(
            fmt::format("isochronous: no equilibrium found after t = {:.6g}: {}. Add output times in between, or check "
                        "whether a load is too large for so long a time",
                        time_, error.what()));
      target = middle;
    }
  }
  const StepReport report{.time = target, .step = target - time_, .order = 0, .error_estimate = 0};
  std::swap(state_, next_);
  time_ = target;
  ++counters_.steps;
  system_.accept(time_, state_);
  return report;
}

void Isochronous::interpolate(double t, std::span<double> y) const {
  if (t != time_) throw std::out_of_range(fmt::format("isochronous: t = {} is not a time it has solved for", t));
  std::ranges::copy(state_, y.begin());
}

}  // namespace creepcontact::ode
