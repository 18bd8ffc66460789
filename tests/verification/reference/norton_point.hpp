#pragma once
/// Norton's flow rule for the principal stresses of an axisymmetric state, and its derivative.

#include <Eigen/Core>
#include <cmath>

namespace creepcontact::reference {

struct NortonPoint {
  double A, n;

  /// Creep strain rate 3/2 A q^(n-1) s of the stresses (r, theta, z)
  Eigen::Vector3d rate(const Eigen::Vector3d& stress) const {
    const Eigen::Vector3d s = stress.array() - stress.mean();
    return 1.5 * A * std::pow(equivalent(s), n - 1) * s;
  }

  Eigen::Matrix3d derivative(const Eigen::Vector3d& stress) const {
    const Eigen::Vector3d s = stress.array() - stress.mean();
    const double q = equivalent(s);
    Eigen::Matrix3d d = Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(1.0 / 3.0);
    if (q > 0) d += 1.5 * (n - 1) / (q * q) * s * s.transpose();
    return 1.5 * A * std::pow(q, n - 1) * d;
  }

 private:
  static double equivalent(const Eigen::Vector3d& s) { return std::sqrt(1.5) * s.norm(); }
};

}  // namespace creepcontact::reference
