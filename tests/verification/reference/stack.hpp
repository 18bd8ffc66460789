#pragma once
/// Bars in series, pressed by a prescribed shortening that may open the joints: stress and creep over time.

#include <algorithm>
#include <functional>
#include <vector>

#include "verification/reference/relaxation.hpp"

namespace creepcontact::reference {

/// Between a bottom that is held and a top that moves; the joints carry no tension. One exponent for all bars.
class Stack {
 public:
  /// @param shortening  of the whole stack beyond touching, over time; negative: the joints are open
  Stack(const std::vector<Bar>& bars, double n, std::function<double(double)> shortening)
      : n_(n), shortening_(std::move(shortening)) {
    for (const Bar& bar : bars) {
      flexibility_ += bar.length / bar.young_modulus;
      creep_ += bar.length * bar.A;
    }
  }

  /// Compressive stress at t, with the classical Runge-Kutta method from 0. @param steps  kinks should fall between
  /// them
  double stress(double t, int steps = 20000) const {
    const double h = t / steps;
    double c = 0;
    for (int i = 0; i < steps; ++i) {
      const double at = i * h;
      const double k1 = rate(at, c), k2 = rate(at + h / 2, c + h / 2 * k1), k3 = rate(at + h / 2, c + h / 2 * k2);
      c += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(at + h, c + h * k3));
    }
    return stress_at(t, c);
  }

 private:
  /// @param c  shortening by creep
  double stress_at(double t, double c) const { return std::max(0.0, shortening_(t) - c) / flexibility_; }
  double rate(double t, double c) const { return creep_ * std::pow(stress_at(t, c), n_); }

  double n_, flexibility_ = 0, creep_ = 0;
  std::function<double(double)> shortening_;
};

}  // namespace creepcontact::reference
