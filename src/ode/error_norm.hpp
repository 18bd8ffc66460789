#pragma once
/// How all integrators with error control measure an error.

#include <cmath>
#include <span>
#include <vector>

#include "elementwise.hpp"

namespace creepcontact::ode {

/// Local errors may take this share of the tolerance. The errors of earlier steps have not all relaxed when the next
/// one is made: with it the error of the stress is below the tolerance in most runs, and below three tolerances at
/// hot spots (thick cylinder, plate with hole, shrink fit, ball on block, blade root; tolerances 1e-2 to 1e-6).
inline constexpr double local_share = 0.4;

/// (mean of x_i^4)^(1/4) of weighted errors x. Hot spots are few among many points: in the root mean square they would
/// be lost (their error was 4 to 18 tolerances), while with a maximum norm or the power 8 every single point that comes
/// into contact costs steps.
/// @param weighted  (begin, length) -> these entries of x, as an Eigen array
template <typename Weighted>
double error_norm(std::size_t size, Weighted weighted) {
  const double sum = sum_over_pieces(
      size, [&](std::size_t begin, std::size_t n) { return weighted(begin, n).square().square().sum(); });
  return std::sqrt(std::sqrt(sum / static_cast<double>(size)));
}

/// Of the errors x_i w_i.
inline double error_norm(std::span<const double> x, std::span<const double> w) {
  return error_norm(x.size(), [=](std::size_t begin, std::size_t n) {
    return piece(x.data(), begin, n) * piece(w.data(), begin, n);
  });
}

/// w_i = 1 / (local share * tolerance * scale_i), without a part relative to the state: as the creep strain grows, the
/// stress would lose its accuracy. @throws std::invalid_argument if a scale is not positive
void set_error_weights(std::span<const double> scale, double tolerance, std::span<double> weights);

/// The norm with these weights: errors up to 1 are accepted.
class ErrorNorm {
 public:
  /// @throws ConfigError if the tolerance is not positive
  explicit ErrorNorm(double tolerance);

  void set_scale(std::span<const double> scale) {
    weights_.resize(scale.size());
    set_error_weights(scale, tolerance_, weights_);
  }

  /// @param error  (begin, length) -> the errors of these entries, as an Eigen array
  template <typename Error>
  double operator()(Error error) const {
    if (weights_.empty()) return 0;
    return error_norm(weights_.size(), [&](std::size_t begin, std::size_t n) {
      return error(begin, n) * piece(weights_.data(), begin, n);
    });
  }

 private:
  double tolerance_;
  std::vector<double> weights_;
};

}  // namespace creepcontact::ode
