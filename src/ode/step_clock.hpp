#pragma once
/// Time of a one-step method, summed with compensation so that rounding leaves no sliver before a limit.

#include <algorithm>
#include <cmath>
#include <limits>

namespace creepcontact::ode {

class StepClock {
 public:
  /// @param lost  of a clock to go on with
  void start(double t, double lost = 0) {
    time_ = t;
    lost_ = lost;
  }
  double time() const { return time_; }
  double lost() const { return lost_; }

  /// For steps under error control: enough to leave no sliver before a limit, too little to spoil the accuracy.
  static constexpr double stretch = 0.1;

  /// Where a step of length dt leads, t_limit at most.
  struct Target {
    double time = 0;
    double step = 0;
    double lost = 0;
  };
  /// A remainder that exceeds dt by rounding only, or by the fraction `max_stretch` of dt, is taken whole.
  Target target(double dt, double t_limit, double max_stretch = 0) const {
    const double rest = t_limit - time_;
    const double rounding =
        std::max(std::max(1e-12, max_stretch) * dt, 4 * std::numeric_limits<double>::epsilon() * std::abs(time_));
    if (rest <= dt + rounding) return {t_limit, rest, 0};
    const double increment = dt - lost_;  // Kahan summation
    const double next = time_ + increment;
    return {next, dt, (next - time_) - increment};
  }
  void advance(const Target& target) {
    time_ = target.time;
    lost_ = target.lost;
  }

 private:
  double time_ = 0;
  double lost_ = 0;  ///< by which the stored time is too large
};

}  // namespace creepcontact::ode
