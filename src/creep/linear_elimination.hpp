#pragma once
/// Elimination of the state of a point from a Newton system where all laws are linear and isotropic.

#include <Eigen/Core>

#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

/// The map of tensors that multiplies deviators by one factor and mean parts by another one.
Matrix6 isotropic(double deviatoric, double volumetric);

/// The system of MaterialTangent at one point whose stress, creep strain and internal variables are m = stride/6
/// tensors (CreepLaw::is_linear): their deviators all have one system of m scalars, their mean parts another one.
class LinearElimination {
 public:
  /// @param points  with is_linear() Cost: 2 (m + 1) directional derivatives, inverses of two m x m matrices
  LinearElimination(const MaterialPoints& points, std::size_t p, double gamma, const PointsState& at);

  /// z with du = 0. @param r, z  m tensors
  void solve(std::span<const double> r, std::span<double> z) const;
  /// [M^-1, N]. @param into  6 m x (6 m + 6)
  void write(Eigen::Ref<Eigen::MatrixXd> into) const;
  /// D
  Matrix6 modulus() const;

 private:
  /// The system of the deviators, or that of the mean parts.
  struct Part {
    Eigen::MatrixXd inverse;   // of M
    Eigen::VectorXd n;         // N
    double modulus;            // D
    Eigen::MatrixXd solution;  // of r: z with du = 0
  };
  Part deviatoric_, volumetric_;
};

}  // namespace creepcontact::creep
