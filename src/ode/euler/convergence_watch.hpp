#pragma once
/// When the inner iterations of an implicit step end.

#include <algorithm>
#include <cmath>
#include <limits>

namespace creepcontact::ode {

/// Told of the change max |G(y) - y| of every iteration, decides whether another one is to follow.
class ConvergenceWatch {
 public:
  enum class State { running, converged, diverging, exhausted };

  ConvergenceWatch(double tolerance, int max_iterations) : tolerance_(tolerance), max_iterations_(max_iterations) {}

  State update(double change) {
    ++iterations_;
    change_ = change;
    if (change <= tolerance_)
      state_ = State::converged;
    else if (!std::isfinite(change) || change > divergence_factor * smallest_)
      state_ = State::diverging;
    else if (iterations_ == max_iterations_)
      state_ = State::exhausted;
    smallest_ = std::min(smallest_, change);
    return state_;
  }

  State state() const { return state_; }
  int iterations() const { return iterations_; }
  double change() const { return change_; }  ///< the last one

 private:
  /// Beyond this growth over the smallest change so far the iterations are taken to diverge; a transient of a
  /// nonlinear law grows less.
  static constexpr double divergence_factor = 1e3;

  double tolerance_;
  int max_iterations_;
  State state_ = State::running;
  int iterations_ = 0;
  double change_ = 0;
  double smallest_ = std::numeric_limits<double>::infinity();
};

}  // namespace creepcontact::ode
