#include "linear_elimination.hpp"

#include <cmath>

#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::creep {
namespace {

/// Unit tensors: any deviator, and the mean part.
Tensor6 unit_deviator() {
  return Tensor6::Unit(5);
}
Tensor6 unit_mean() {
  return tensor::identity() / std::sqrt(3.0);
}

}  // namespace

Matrix6 isotropic(double deviatoric, double volumetric) {
  Matrix6 result = deviatoric * Matrix6::Identity();
  result.topLeftCorner<3, 3>().array() += (volumetric - deviatoric) / 3;
  return result;
}

LinearElimination::LinearElimination(const MaterialPoints& points, std::size_t p, double gamma, const PointsState& at) {
  const auto stride = static_cast<Index>(points.stride()), m = stride / 6;
  Eigen::VectorXd state = Eigen::VectorXd::Zero(stride), rate(stride);
  const auto part = [&](const Tensor6& unit, double stiffness) {
    // The coefficients along the unit tensor of the change of all rates.
    const auto change = [&](const Tensor6& stress) {
      points.derivative_at(p, at, {.stress = {stress.data(), 6}, .state = {state.data(), points.stride()}},
                           {rate.data(), points.stride()});
      return Eigen::VectorXd(Eigen::Map<const Eigen::Matrix<double, 6, -1>>(rate.data(), 6, m).transpose() * unit);
    };
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(m, m);
    for (Index j = 0; j < m; ++j) {
      state.segment<6>(6 * j) = unit;
      system.col(j) -= gamma * change(Tensor6::Zero());
      state.setZero();
    }
    Part result{.inverse = linalg::inverse(system), .n = {}, .modulus = 0, .solution = {}};
    result.n = gamma * (result.inverse * change(unit));
    result.modulus = 1 / (1 / stiffness + result.n[0]);
    result.solution = result.inverse - result.modulus * result.n * result.inverse.row(0);
    return result;
  };
  const material::Moduli& elastic = at.elastic.at(p);
  deviatoric_ = part(unit_deviator(), 2 * elastic.mu);
  volumetric_ = part(unit_mean(), 3 * elastic.lambda + 2 * elastic.mu);
}

void LinearElimination::solve(std::span<const double> r, std::span<double> z) const {
  const Index m = deviatoric_.n.size();
  const Eigen::Map<const Eigen::Matrix<double, 6, -1>> right(r.data(), 6, m);
  Eigen::Map<Eigen::Matrix<double, 6, -1>> result(z.data(), 6, m);
  for (Index i = 0; i < m; ++i) {
    Tensor6 sum = Tensor6::Zero();
    double mean = 0;
    for (Index j = 0; j < m; ++j) {
      sum += deviatoric_.solution(i, j) * right.col(j);
      mean += (volumetric_.solution(i, j) - deviatoric_.solution(i, j)) * right.col(j).head<3>().sum();
    }
    sum.head<3>().array() += mean / 3;
    result.col(i) = sum;
  }
}

void LinearElimination::write(Eigen::Ref<Eigen::MatrixXd> into) const {
  const Index m = deviatoric_.n.size();
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < m; ++j)
      into.block<6, 6>(6 * i, 6 * j) = isotropic(deviatoric_.inverse(i, j), volumetric_.inverse(i, j));
    into.block<6, 6>(6 * i, 6 * m) = isotropic(deviatoric_.n[i], volumetric_.n[i]);
  }
}

Matrix6 LinearElimination::modulus() const {
  return isotropic(deviatoric_.modulus, volumetric_.modulus);
}

}  // namespace creepcontact::creep
