#pragma once
/// Thick cylinder under internal pressure with a temperature T(r), thermal strain and Norton creep whose A follows the
/// temperature. Axisymmetric, plane strain. Radial elements of high degree, as in RingFit: stress' = M f(stress, r).

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "verification/reference/norton_point.hpp"
#include "verification/reference/polynomial.hpp"
#include "verification/reference/stiff_integrator.hpp"

namespace creepcontact::reference {

struct HotCylinder {
  double inner, outer, pressure;
  double young_modulus, poisson_ratio, n;
  std::function<double(double)> A;               ///< of the radius
  std::function<double(double)> thermal_strain;  ///< of the radius
};

class HotCylinderHistory {
 public:
  explicit HotCylinderHistory(const HotCylinder& cylinder, int elements = 2, int degree = 7, double tolerance = 1e-9);

  /// Radii of the points, increasing.
  const std::vector<double>& radii() const { return radii_; }
  /// Stress (r, theta, z) at every point, at increasing times >= 0.
  std::vector<std::vector<Eigen::Vector3d>> stress(const std::vector<double>& times) const;

 private:
  Eigen::VectorXd creep(const Eigen::VectorXd& stress) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& stress) const;

  double tolerance_;
  std::vector<NortonPoint> laws_;
  std::vector<double> radii_;
  Eigen::MatrixXd response_;  ///< stress of a creep strain
  Eigen::VectorXd elastic_;   ///< stress before any creep
};

}  // namespace creepcontact::reference
