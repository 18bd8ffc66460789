#pragma once
/// How all integrators with error control measure an error.

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "elementwise.hpp"

namespace creepcontact::ode {

/// Local errors may take this share of the tolerance. The errors of earlier steps have not all relaxed when the next
/// one is made: with it the error of the stress is below the tolerance in most runs, and below three tolerances at
/// hot spots (thick cylinder, plate with hole, shrink fit, ball on block, blade root; tolerances 1e-2 to 1e-6).
inline constexpr double local_share = 0.4;

/// (mean of x_i^4)^(1/4) of weighted errors x. Hot spots are few among many points: in the root mean square they would
/// be lost (their error was 4 to 18 tolerances), while with a maximum norm or the power 8 every single point that comes
/// into contact costs steps.
/// Collective: x is what all members of the team have. 0 if that is nothing.
/// @param size  of the part of this member
/// @param weighted  (begin, length) -> these entries of its part of x, as an Eigen array
/// @param sum  (size, term) -> sum of term(begin, length) over the pieces of its part
template <typename Weighted, typename Sum>
double error_norm(const Team& team, std::size_t size, const Weighted& weighted, const Sum& sum) {
  std::array<double, 2> sums{
      sum(size, [&](std::size_t begin, std::size_t n) { return weighted(begin, n).square().square().sum(); }),
      static_cast<double>(size)};
  team.sum(sums);
  return sums[1] > 0 ? std::sqrt(std::sqrt(sums[0] / sums[1])) : 0;
}

template <typename Weighted>
double error_norm(const Team& team, std::size_t size, const Weighted& weighted) {
  return error_norm(team, size, weighted, [](std::size_t n, const auto& term) { return sum_over_pieces(n, term); });
}

/// Norm of the errors x_i w_i.
inline double error_norm(const Team& team, std::span<const double> x, std::span<const double> w) {
  return error_norm(team, x.size(), [=](std::size_t begin, std::size_t n) {
    return piece(x.data(), begin, n) * piece(w.data(), begin, n);
  });
}

/// w_i = 1 / (local share * tolerance * scale_i), without a part relative to the state: as the creep strain grows, the
/// stress would lose its accuracy. @throws std::invalid_argument if a scale is not positive
void set_error_weights(std::span<const double> scale, double tolerance, std::span<double> weights);

/// The norm with these weights: errors up to 1 are accepted.
class ErrorNorm {
 public:
  /// @param team  must outlive the object. @throws ConfigError if the tolerance is not positive
  ErrorNorm(const Team& team, double tolerance);

  void set_scale(std::span<const double> scale) {
    weights_.resize(scale.size());
    set_error_weights(scale, tolerance_, weights_);
  }

  /// @param error  (begin, length) -> the errors of these entries, as an Eigen array
  template <typename Error>
  double operator()(Error error) const {
    return error_norm(team_, weights_.size(), [&](std::size_t begin, std::size_t n) {
      return error(begin, n) * piece(weights_.data(), begin, n);
    });
  }

 private:
  const Team& team_;
  double tolerance_;
  std::vector<double> weights_;
};

}  // namespace creepcontact::ode
