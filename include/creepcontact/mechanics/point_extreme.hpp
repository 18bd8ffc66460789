#pragma once
/// The largest or smallest of values at the integration points of a body, and its place.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::mechanics {

inline constexpr double point_rounding = 1e-9;  ///< of values that are interpolated

using PointExtreme = std::array<double, 4>;  ///< a value, and its place

/// Collective. @param sign  1: the largest, -1: the smallest @param values  of the points of this process;
/// may be empty there
inline PointExtreme point_extreme(const Body& body, const std::vector<double>& values, int sign, const Team& team) {
  double rank_by = -std::numeric_limits<double>::infinity();
  for (const double value : values) rank_by = std::max(rank_by, sign * value);
  // Where several points have it but for rounding, the first.
  const auto first = std::ranges::find_if(
      values, [=](double value) { return sign * value >= rank_by - point_rounding * std::abs(rank_by); });
  PointExtreme result{};
  if (first != values.end()) {
    const Vector3& x = body.discretization().point_coordinates()[first - values.begin()];
    result = {*first, x[0], x[1], x[2]};
  }
  team.broadcast(result, team.rank_of_max(rank_by));
  return result;
}

}  // namespace creepcontact::mechanics
