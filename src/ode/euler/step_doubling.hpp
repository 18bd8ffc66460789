#pragma once
/// Error control by step doubling: one step against two of half the length, which are the result.
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I (1993), II.4.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../error_norm.hpp"
#include "../step_clock.hpp"

namespace creepcontact::ode {

/// What a step of an Euler scheme begins and ends with.
struct EulerPoint {
  std::vector<double> state, rate;
  std::vector<double>
      load_residual;  ///< of the inner iterations, see ResidualCorrection; schemes without them have none
};

class StepDoubling {
 public:
  /// @param sizes  of all points. @throws ConfigError if the tolerance is not positive
  StepDoubling(const Team& team, const EulerPoint& sizes, double tolerance)
      : norm_(team, tolerance), whole_(sizes), middle_(sizes) {}

  void set_scale(std::span<const double> scale) { norm_.set_scale(scale); }
  const ErrorNorm& norm() const { return norm_; }
  EulerPoint& work() { return whole_; }

  /// Makes `to`. @returns its error in units of the tolerance: with order p, the difference / (2^p - 1) (Richardson)
  /// @param advance   (from, target, to); @param complete  (t, to): makes `to` a point to begin with
  template <typename Advance, typename Complete>
  double run(double t, const EulerPoint& from, const StepClock::Target& target, int order, EulerPoint& to,
             Advance advance, Complete complete) {
    const double half = 0.5 * target.step;
    const StepClock::Target to_middle{t + half, half, 0};
    advance(from, target, whole_);
    advance(from, to_middle, middle_);
    complete(to_middle.time, middle_);
    advance(middle_, {target.time, half, 0}, to);
    complete(target.time, to);
    const double difference = norm_([&](std::size_t begin, std::size_t n) {
      return piece(std::as_const(to.state).data(), begin, n) - piece(std::as_const(whole_.state).data(), begin, n);
    });
    return difference / (std::exp2(order) - 1);
  }

  /// Next step over this one, for an error of order p + 1.
  static double factor(double error, int order) {
    if (!std::isfinite(error)) return largest_cut;
    return std::clamp(safety * std::pow(error, -1.0 / (order + 1)), largest_cut, largest_growth);
  }

 private:
  static constexpr double safety = 0.9, largest_cut = 0.2, largest_growth = 5;

  ErrorNorm norm_;
  EulerPoint whole_, middle_;
};

}  // namespace creepcontact::ode
