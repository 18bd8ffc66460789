#pragma once
/// Preconditioner (I + gamma C H)^-1 point by point, with C = d(rate)/d(stress), in closed form for isotropic laws
/// (Sherman and Morrison). Laws without internal variables: 6 numbers per point.

#include <array>
#include <span>
#include <vector>

#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

/// One object per body. linearize() must precede apply().
class PointPreconditioner {
 public:
  /// Computes and stores C H of every point. Cost: one pass over the points.
  /// @param tangents  of MaterialPoints::tangents(at)
  void linearize(const PointsState& at, std::span<const material::StressTangent> tangents);
  /// z = (I + gamma C H)^-1 r. @param r, z  n_points x 6
  void apply(double gamma, std::span<const double> r, std::span<double> z) const;
  /// apply() with C H at `at`, which is not stored.
  static void apply_once(const PointsState& at, std::span<const material::StressTangent> tangents, double gamma,
                         std::span<const double> r, std::span<double> z);

 private:
  /// C H of one point.
  struct Local {
    std::array<double, 6> deviator;         // of the stress
    double inverse_square;                  // 1 / its squared length; 0 without a deviator
    double deviatoric, radial, volumetric;  // coefficients of C H, see material::StressTangent

    Local() = default;
    Local(const PointsState& at, const material::StressTangent& tangent, std::size_t p);
    void apply(double gamma, const double* r, double* z) const;
  };
  std::vector<Local> locals_;
};

}  // namespace creepcontact::creep
