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

  /// Integral of dt / step up to `end`; none while too little has been seen to extrapolate.
  std::optional<double> count(double end) const {
    if (seen_.empty()) return std::nullopt;
    const Seen now = seen_.back();
    const auto later =
        std::find_if(seen_.begin(), seen_.end(), [&](const Seen& seen) { return seen.time > now.time / lookback; });
    if (later == seen_.begin()) return std::nullopt;
    const Seen then = *(later - 1);
    const double power = std::clamp(std::log(now.step / then.step) / std::log(now.time / then.time), -1.0, 1.5);
    const double times = (end - begin_) / now.time, rest = 1 - power;
    const double factor = std::abs(rest) < 1e-6 ? std::log(times) : (std::pow(times, rest) - 1) / rest;
    return now.time / now.step * factor;
  }
  /// Decades of time that lie ahead. Call after add().
  double decades(double end) const { return std::log10((end - begin_) / seen_.back().time); }

 private:
  static constexpr double lookback = 3;
  struct Seen {
    double time, step;
  };
  double begin_ = 0;
  std::vector<Seen> seen_;
};

}  // namespace creepcontact::ode
