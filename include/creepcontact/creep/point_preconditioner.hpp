#pragma once
/// (I + gamma C H)^-1 point by point, C = d(rate)/d(stress), in the closed form of Sherman and Morrison for isotropic
/// laws. Internal variables are left as they are.

#include <vector>

#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

class PointPreconditioner {
 public:
  explicit PointPreconditioner(std::size_t stride) : stride_(stride) {}

  /// Keeps C H of every point. Cost: one pass over the points.
  void linearize(const MaterialPoints& points, const PointsState& at);
  /// z = (I + gamma C H)^-1 r. @param r, z  n_points x stride
  void apply(double gamma, const double* r, double* z) const;

 private:
  struct Local {
    double direction[6];                    // of the stress deviator, unit length
    double deviatoric, radial, volumetric;  // parts of C H
  };
  std::size_t stride_;
  std::vector<Local> locals_;
};

}  // namespace creepcontact::creep
