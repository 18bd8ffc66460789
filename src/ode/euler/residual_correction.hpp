#pragma once
/// The residual of nodal forces that an inner iteration leaves behind, and what becomes of it.

#include <span>

#include "../elementwise.hpp"

namespace creepcontact::ode {

/// In the article's incremental form the last equilibrium of a step was found with the creep strain e_n, one
/// iteration older than the strain y_n that the step ends with; delta_n = y_n - e_n is the residual, as a strain.
/// Iteration k of the next step solves equilibrium with
///   e^(k) = e_n + (y^(k) - y_n) + gamma delta_n = y^(k) - (1 - gamma) delta_n,
/// where gamma is the fraction of the residual carried into the next load. gamma = 1 leaves nothing behind; with
/// gamma = 0 the residuals of all steps add up, each at most the inner tolerance.
/// Source: Stankevich (2012), correction of the load vector by the residual.
class ResidualCorrection {
 public:
  explicit ResidualCorrection(double gamma) : gamma_(gamma) {}

  /// The strain e^(k) with which to solve equilibrium for the iterate y of a step that begins with the residual.
  void load(std::span<const double> y, std::span<const double> residual, std::span<double> e) const {
    for_each_index(y.size(), [&](std::size_t i) { e[i] = y[i] - (1 - gamma_) * residual[i]; });
  }
  /// What a step leaves that ended with y, computed from the equilibrium under e.
  static void residual(std::span<const double> y, std::span<const double> e, std::span<double> left) {
    for_each_index(y.size(), [&](std::size_t i) { left[i] = y[i] - e[i]; });
  }

 private:
  double gamma_;
};

}  // namespace creepcontact::ode
