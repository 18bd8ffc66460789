#pragma once
/// Pressure between two rings pressed together with interference, both creeping by Norton's law.
/// Axisymmetric, plane strain or plane stress. Radial elements of high degree; the creep strains are eliminated: with
/// the interference held, stress' = M f(stress), M = D (B K^-1 B^T D - 1) constant.

#include <Eigen/Core>
#include <vector>

#include "verification/reference/norton_point.hpp"
#include "verification/reference/polynomial.hpp"
#include "verification/reference/stiff_integrator.hpp"

namespace creepcontact::reference {

struct Ring {
  double inner, outer;  ///< radii; the bore of the outer ring and the outer radius of the inner one are both R
  double young_modulus, poisson_ratio;
  double A, n;  ///< rate = A q^n; A = 0: elastic
};

enum class Plane { strain, stress };

struct RingFitAccuracy {
  int elements = 2;  ///< through each ring
  int degree = 7;
  double tolerance = 1e-9;  ///< local error of the stress over the largest stress
};

class RingFit {
 public:
  /// @param interference  outer radius of the inner ring minus bore of the outer ring, before assembly
  RingFit(const Ring& inside, const Ring& outside, double interference, Plane plane, RingFitAccuracy accuracy = {});

  double elastic_pressure() const { return pressure_of_stress_.dot(elastic_stress_); }

  /// Pressure at increasing times >= 0.
  std::vector<double> pressure(const std::vector<double>& times) const;

 private:
  Eigen::VectorXd creep(const Eigen::VectorXd& stress) const;

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& stress) const;

  static Eigen::Matrix3d elasticity(const Ring& ring, Plane plane);

  void assemble(const Ring& inside, const Ring& outside, double interference, Plane plane,
                const RingFitAccuracy& accuracy);

  double tolerance_;
  std::vector<NortonPoint> laws_;
  Eigen::MatrixXd response_;            ///< stress rate of a creep strain rate
  Eigen::VectorXd pressure_of_stress_;  ///< weights
  Eigen::VectorXd elastic_stress_;
};

}  // namespace creepcontact::reference
