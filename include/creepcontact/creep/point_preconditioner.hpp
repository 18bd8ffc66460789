#pragma once
/// (I + gamma C H)^-1 point by point, C = d(rate)/d(stress), in the closed form of Sherman and Morrison for isotropic
/// laws. Internal variables are left as they are.

#include <array>
#include <span>
#include <vector>

#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

class PointPreconditioner {
 public:
  explicit PointPreconditioner(std::size_t stride) : stride_(stride) {}

  /// Keeps C H of every point. Cost: one pass over the points.
  void linearize(const MaterialPoints& points, const PointsState& at);
  /// z = (I + gamma C H)^-1 r. @param r, z  n_points x stride
  void apply(double gamma, std::span<const double> r, std::span<double> z) const;

 private:
  struct Local {
    std::array<double, 6> direction;        // of the stress deviator, unit length
    double deviatoric, radial, volumetric;  // parts of C H
  };
  std::size_t stride_;
  std::vector<Local> locals_;
};

}  // namespace creepcontact::creep
