#include "verification/reference/hot_cylinder.hpp"

#include <Eigen/Cholesky>

namespace creepcontact::reference {

HotCylinderHistory::HotCylinderHistory(const HotCylinder& cylinder, int elements, int degree, double tolerance)
    : tolerance_(tolerance) {
  const LagrangeBasis basis(degree);
  const GaussRule rule = gauss_rule(degree + 2);
  const int n_dofs = elements * degree + 1, n_points = elements * static_cast<int>(rule.points.size());
  const double length = (cylinder.outer - cylinder.inner) / elements;
  const double E = cylinder.young_modulus, nu = cylinder.poisson_ratio;
  const double mu = E / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu);
  Eigen::MatrixXd strain = Eigen::MatrixXd::Zero(3 * n_points, n_dofs);  // (u', u/r, 0) at every point
  Eigen::MatrixXd moduli = Eigen::MatrixXd::Zero(3 * n_points, 3 * n_points);
  Eigen::VectorXd measure(3 * n_points), thermal(3 * n_points);
  for (int e = 0, point = 0; e < elements; ++e)
    for (int g = 0; g < rule.points.size(); ++g, ++point) {
      const double xi = rule.points[g], r = cylinder.inner + length * (e + 0.5 * (xi + 1));
      const int row = 3 * point;
      for (int i = 0; i <= degree; ++i) {
        strain(row, e * degree + i) = basis.slope(i, xi) * 2 / length;
        strain(row + 1, e * degree + i) = basis.value(i, xi) / r;
      }
      measure.segment<3>(row).setConstant(0.5 * length * rule.weights[g] * r);
      thermal.segment<3>(row).setConstant(cylinder.thermal_strain(r));
      moduli.block<3, 3>(row, row) = 2 * mu * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(lambda);
      laws_.push_back({cylinder.A(r), cylinder.n});
      radii_.push_back(r);
    }
  const Eigen::MatrixXd force = strain.transpose() * measure.asDiagonal() * moduli;  // of a creep strain
  const auto stiffness = (force * strain).eval().ldlt();
  response_ = moduli * (strain * stiffness.solve(force) - Eigen::MatrixXd::Identity(3 * n_points, 3 * n_points));
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n_dofs);
  load[0] = cylinder.pressure * cylinder.inner;
  elastic_ = moduli * (strain * stiffness.solve(load)) + response_ * thermal;
}

std::vector<std::vector<Eigen::Vector3d>> HotCylinderHistory::stress(const std::vector<double>& times) const {
  StiffIntegrator integrator([this](const Eigen::VectorXd& s) { return Eigen::VectorXd(response_ * creep(s)); },
                             [this](const Eigen::VectorXd& s) { return jacobian(s); }, elastic_, tolerance_);
  std::vector<std::vector<Eigen::Vector3d>> result;
  for (const double t : times) {
    const Eigen::VectorXd state = integrator.advance(t);
    auto& points = result.emplace_back();
    for (std::size_t p = 0; p < laws_.size(); ++p) points.emplace_back(state.segment<3>(3 * p));
  }
  return result;
}

Eigen::VectorXd HotCylinderHistory::creep(const Eigen::VectorXd& stress) const {
  Eigen::VectorXd rate(stress.size());
  for (std::size_t p = 0; p < laws_.size(); ++p) rate.segment<3>(3 * p) = laws_[p].rate(stress.segment<3>(3 * p));
  return rate;
}

Eigen::MatrixXd HotCylinderHistory::jacobian(const Eigen::VectorXd& stress) const {
  Eigen::MatrixXd result(stress.size(), stress.size());
  for (std::size_t p = 0; p < laws_.size(); ++p)
    result.middleCols<3>(3 * p) = response_.middleCols<3>(3 * p) * laws_[p].derivative(stress.segment<3>(3 * p));
  return result;
}

}  // namespace creepcontact::reference
