#pragma once
/// Norms of a state whose parts the members of a team hold. Collective: all members get the same bits.

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "creepcontact/base/team.hpp"
#include "elementwise.hpp"

namespace creepcontact::ode {

/// max |a_i - b_i|; NaN if any difference is NaN.
inline double max_difference(const Team& team, std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  bool nan = false;
#pragma omp parallel for schedule(static) reduction(max        \
                                                    : largest) \
    reduction(||                                               \
              : nan) if (a.size() >= numerics::parallel_entries)
  for (std::size_t begin = 0; begin < a.size(); begin += piece_length) {
    const std::size_t length = std::min(piece_length, a.size() - begin);
    const double here = (piece(a.data(), begin, length) - piece(b.data(), begin, length))
                            .abs()
                            .template maxCoeff<Eigen::PropagateNaN>();
    if (std::isnan(here))
      nan = true;
    else
      largest = std::max(largest, here);
  }
  std::array<double, 2> of_all{largest, nan ? 1.0 : 0.0};
  team.max(of_all);
  return of_all[1] > 0 ? std::numeric_limits<double>::quiet_NaN() : of_all[0];
}

inline double euclidean_norm(const Team& team, std::span<const double> v) {
  return std::sqrt(team.sum(sum_over_pieces(
      v.size(), [&](std::size_t begin, std::size_t n) { return piece(v.data(), begin, n).square().sum(); })));
}

}  // namespace creepcontact::ode
