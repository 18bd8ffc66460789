#include "verification/reference/ring_fit.hpp"

#include <Eigen/Cholesky>

namespace creepcontact::reference {

RingFit::RingFit(const Ring& inside, const Ring& outside, double interference, Plane plane, RingFitAccuracy accuracy)
    : tolerance_(accuracy.tolerance) {
  assemble(inside, outside, interference, plane, accuracy);
}

std::vector<double> RingFit::pressure(const std::vector<double>& times) const {
  StiffIntegrator integrator(
      [this](const Eigen::VectorXd& stress) { return Eigen::VectorXd(response_ * creep(stress)); },
      [this](const Eigen::VectorXd& stress) { return jacobian(stress); }, elastic_stress_, tolerance_);
  std::vector<double> result;
  for (const double t : times) result.push_back(pressure_of_stress_.dot(integrator.advance(t)));
  return result;
}

Eigen::VectorXd RingFit::creep(const Eigen::VectorXd& stress) const {
  Eigen::VectorXd rate(stress.size());
  for (std::size_t p = 0; p < laws_.size(); ++p) rate.segment<3>(3 * p) = laws_[p].rate(stress.segment<3>(3 * p));
  return rate;
}

Eigen::MatrixXd RingFit::jacobian(const Eigen::VectorXd& stress) const {
  Eigen::MatrixXd result(stress.size(), stress.size());
  for (std::size_t p = 0; p < laws_.size(); ++p)
    result.middleCols<3>(3 * p) = response_.middleCols<3>(3 * p) * laws_[p].derivative(stress.segment<3>(3 * p));
  return result;
}

Eigen::Matrix3d RingFit::elasticity(const Ring& ring, Plane plane) {
  const double E = ring.young_modulus, nu = ring.poisson_ratio;
  if (plane == Plane::stress) {
    Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
    d.topLeftCorner<2, 2>() << 1, nu, nu, 1;
    return E / (1 - nu * nu) * d;
  }
  const double mu = E / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu);
  return 2 * mu * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(lambda);
}

void RingFit::assemble(const Ring& inside, const Ring& outside, double interference, Plane plane,
                       const RingFitAccuracy& accuracy) {
  const LagrangeBasis basis(accuracy.degree);
  const GaussRule rule = gauss_rule(accuracy.degree + 2);
  const int per_ring = accuracy.elements * accuracy.degree;
  const int n_dofs = 2 * per_ring + 1;  // both rings share the unknown at R; the outer one adds the interference
  const int n_points = 2 * accuracy.elements * static_cast<int>(rule.points.size());
  Eigen::MatrixXd strain = Eigen::MatrixXd::Zero(3 * n_points, n_dofs);  // B: (u', u/r, 0) at every point
  Eigen::MatrixXd moduli = Eigen::MatrixXd::Zero(3 * n_points, 3 * n_points);
  Eigen::VectorXd measure(3 * n_points);
  Eigen::VectorXd jump = Eigen::VectorXd::Zero(3 * n_points);  // strain of the interference put on the outer ring
  pressure_of_stress_ = Eigen::VectorXd::Zero(3 * n_points);

  int point = 0;
  for (const bool outer : {false, true}) {
    const Ring& ring = outer ? outside : inside;
    const double length = (ring.outer - ring.inner) / accuracy.elements;
    for (int e = 0; e < accuracy.elements; ++e) {
      for (int g = 0; g < rule.points.size(); ++g, ++point) {
        const double xi = rule.points[g], r = ring.inner + length * (e + 0.5 * (xi + 1));
        const int row = 3 * point, first = (outer ? per_ring : 0) + e * accuracy.degree;
        for (int i = 0; i <= accuracy.degree; ++i) {
          strain(row, first + i) = basis.slope(i, xi) * 2 / length;
          strain(row + 1, first + i) = basis.value(i, xi) / r;
        }
        if (outer && e == 0) jump.segment<3>(row) = interference * strain.block<3, 1>(row, per_ring);
        measure.segment<3>(row).setConstant(0.5 * length * rule.weights[g] * r);
        // The inner ring's nodal force at R is -p R.
        if (!outer)
          pressure_of_stress_.segment<3>(row) = -measure[row] / ring.outer * strain.block<3, 1>(row, per_ring);
        moduli.block<3, 3>(row, row) = elasticity(ring, plane);
        laws_.push_back({ring.A, ring.n});
      }
    }
  }
  const Eigen::MatrixXd force = strain.transpose() * measure.asDiagonal() * moduli;  // of a creep strain
  const Eigen::MatrixXd displacement = (force * strain).ldlt().solve(force);
  response_ = moduli * (strain * displacement - Eigen::MatrixXd::Identity(3 * n_points, 3 * n_points));
  elastic_stress_ = -response_ * jump;  // the jump acts as a creep strain of opposite sign
}

}  // namespace creepcontact::reference
