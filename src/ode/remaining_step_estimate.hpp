#pragma once
/// How many steps a method would still take.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace creepcontact::ode {

/// Told of the length of its steps now and then, extrapolates it as a power of the time since the loads last turned: it
/// grows with the time while stress relaxes (few steps a decade); where creep becomes steady, that of a method without
/// implicit solves stays (many).
class RemainingStepEstimate {
 public:
  void begin(double t) {
    begin_ = t;
    seen_.clear();
  }
  double begin() const { return begin_; }

  void add(double t, double step) { seen_.push_back({t - begin_, step}); }

  /// Integral of dt / step up to `end`. While too little has been seen to extrapolate, the fewest steps that are usual:
  /// these may already be too many, where a law becomes stiff long after the loads turned. None before add().
  std::optional<double> count(double end) const {
    if (seen_.empty()) return std::nullopt;
    const Seen now = seen_.back();
    const auto later =
        std::find_if(seen_.begin(), seen_.end(), [&](const Seen& seen) { return seen.time > now.time / lookback; });
    double power = max_power;
    if (later != seen_.begin()) {
      const Seen then = *(later - 1);
      power = std::clamp(std::log(now.step / then.step) / std::log(now.time / then.time), -1.0, max_power);
    }
    const double times = (end - begin_) / now.time, rest = 1 - power;
    const double factor = std::abs(rest) < 1e-6 ? std::log(times) : (std::pow(times, rest) - 1) / rest;
    return now.time / now.step * factor;
  }
  /// Decades of time that lie ahead. Call after add().
  double decades(double end) const { return std::log10((end - begin_) / seen_.back().time); }

 private:
  static constexpr double lookback = 3, max_power = 1.5;
  struct Seen {
    double time, step;
  };
  double begin_ = 0;
  std::vector<Seen> seen_;
};

}  // namespace creepcontact::ode
