#pragma once
/// Preconditioner (I + gamma C H)^-1 point by point, with C = d(rate)/d(stress), in closed form for isotropic laws
/// (Sherman and Morrison). Internal variables are passed through unchanged.

#include <array>
#include <span>
#include <vector>

#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

/// One object per body. linearize() must precede apply().
class PointPreconditioner {
 public:
  /// @param stride  state variables per point (StateLayout)
  explicit PointPreconditioner(std::size_t stride) : stride_(stride) {}

  /// Computes and stores C H of every point. Cost: one pass over the points.
  /// @param tangents  of MaterialPoints::tangents(at)
  void linearize(const PointsState& at, std::span<const material::StressTangent> tangents);
  /// z = (I + gamma C H)^-1 r. @param r, z  n_points x stride
  void apply(double gamma, std::span<const double> r, std::span<double> z) const;

 private:
  struct Local {
    std::array<double, 6> direction;        // of the stress deviator, unit length
    double deviatoric, radial, volumetric;  // coefficients of C H, see material::StressTangent
  };
  std::size_t stride_;
  std::vector<Local> locals_;
};

}  // namespace creepcontact::creep
