#pragma once
/// How all integrators with error control measure an error.

#include <cmath>
#include <span>

#include "elementwise.hpp"

namespace creepcontact::ode {

/// Local errors may take this share of the tolerance. The errors of earlier steps have not all relaxed when the next
/// one is made: with it the error of the stress is below the tolerance in most runs, and below three tolerances at
/// hot spots (thick cylinder, plate with hole, shrink fit, ball on block, blade root; tolerances 1e-2 to 1e-6).
inline constexpr double local_share = 0.4;

/// (mean of (x_i w_i)^4)^(1/4). Hot spots are few among many points: in the root mean square they would be lost (their
/// error was 4 to 18 tolerances), while with a maximum norm or the power 8 every single point that comes into contact
/// costs steps.
inline double error_norm(std::span<const double> x, std::span<const double> w) {
  const double sum = sum_over_pieces(x.size(), [=](std::size_t begin, std::size_t n) {
    return (piece(x.data(), begin, n) * piece(w.data(), begin, n)).square().square().sum();
  });
  return std::sqrt(std::sqrt(sum / static_cast<double>(x.size())));
}

/// w_i = 1 / (local share * tolerance * scale_i), without a part relative to the state: as the creep strain grows, the
/// stress would lose its accuracy. @throws std::invalid_argument if a scale is not positive
void set_error_weights(std::span<const double> scale, double tolerance, std::span<double> weights);

}  // namespace creepcontact::ode
