#include "creepcontact/creep/material_tangent.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "creepcontact/base/index.hpp"
#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {
namespace {

Matrix6 compliance(const mechanics::ElasticState& elastic, std::size_t point) {
  if (!elastic.matrices.empty()) return elastic.matrices[point].llt().solve(Matrix6::Identity());
  const material::Moduli& h = elastic.at(point);
  const double volumetric = 1 / (3 * (3 * h.lambda + 2 * h.mu)), deviatoric = 1 / (2 * h.mu);
  Matrix6 result = deviatoric * Matrix6::Identity();
  result.topLeftCorner<3, 3>().array() += volumetric - deviatoric / 3;
  return result;
}

}  // namespace

struct MaterialTangent::Work {
  explicit Work(Index stride) : unit(stride), by_state(stride, stride), by_stress(stride, 6) {}
  Eigen::VectorXd unit;
  Eigen::MatrixXd by_state;                // A
  Eigen::Matrix<double, -1, 6> by_stress;  // C
  Eigen::MatrixXd own;                     // the part of M that has to be inverted
  Eigen::PartialPivLU<Eigen::MatrixXd> elimination;
};

MaterialTangent::MaterialTangent(const MaterialPoints& points)
    : points_(points),
      n_points_(points.size()),
      stride_(points.stride()),
      moduli_(n_points_),
      eliminated_(n_points_ * stride_ * (stride_ + 6)) {}

Index MaterialTangent::first_state(std::size_t p, const PointsState& at, Work& work) const {
  const Tensor6 no_stress = Tensor6::Zero();
  work.unit.setZero();
  // A direction that no law with a derivative could be insensitive to by symmetry.
  work.unit.head<6>() << 0.4361, -0.8273, 0.2918, 0.6157, -0.3574, 0.9139;
  points_.derivative_at(p, at, {.stress = {no_stress.data(), 6}, .state = {work.unit.data(), stride_}},
                        {work.by_state.col(0).data(), stride_});
  return work.by_state.col(0).isZero(0) ? 6 : 0;
}

void MaterialTangent::prepare_point(std::size_t p, double gamma, const PointsState& at, Work& work) {
  const Index n = stride_;
  Tensor6 stress = Tensor6::Zero();
  const PointsChange change{.stress = {stress.data(), 6}, .state = {work.unit.data(), stride_}};
  const Index first = first_state(p, at, work), own = n - first;
  for (Index j = first; j < n; ++j) {
    work.unit = Eigen::VectorXd::Unit(n, j);
    points_.derivative_at(p, at, change, {work.by_state.col(j).data(), stride_});
  }
  work.unit.setZero();
  for (Index j = 0; j < 6; ++j) {
    stress = Tensor6::Unit(j);
    points_.derivative_at(p, at, change, {work.by_stress.col(j).data(), stride_});
  }

  Eigen::Map<Eigen::MatrixXd> eliminated(&eliminated_[p * stride_ * (stride_ + 6)], n, n + 6);
  eliminated.leftCols(n).setIdentity();
  eliminated.rightCols<6>() = gamma * work.by_stress;
  // Rates of secondary creep do not depend on the state.
  const auto by_own = work.by_state.rightCols(own);
  if (!by_own.isZero(0)) {
    // M = [I, -gamma A_c; 0, I - gamma A_i]: only the second block is inverted if nothing depends on the creep strain.
    work.own = -gamma * by_own.bottomRows(own);
    work.own.diagonal().array() += 1;
    work.elimination.compute(work.own);
    eliminated.bottomRightCorner(own, own + 6) =
        work.elimination.solve(eliminated.bottomRightCorner(own, own + 6)).eval();
    if (first > 0)
      eliminated.topRightCorner(first, own + 6) +=
          (gamma * by_own.topRows(first)).lazyProduct(eliminated.bottomRightCorner(own, own + 6));
  }
  const Matrix6 modulus =
      Matrix6(compliance(at.elastic, p) + eliminated.topRightCorner<6, 6>()).partialPivLu().inverse();
  moduli_[p] = 0.5 * (modulus + modulus.transpose());
}

void MaterialTangent::prepare(double gamma, const PointsState& at) {
#pragma omp parallel if (n_points_ > numerics::parallel_tangents)
  {
    Work work(stride_);
#pragma omp for schedule(static)
    for (std::size_t p = 0; p < n_points_; ++p) prepare_point(p, gamma, at, work);
  }
}

Eigen::Map<const Eigen::MatrixXd> MaterialTangent::eliminated_at(std::size_t p) const {
  const Index n = stride_;
  return {&eliminated_[p * stride_ * (stride_ + 6)], n, n + 6};
}

void MaterialTangent::initial_stress(std::span<const double> r, std::span<double> stress) const {
  const Index n = stride_;
#pragma omp parallel for schedule(static) if (n_points_ > numerics::parallel_tangents)
  for (std::size_t p = 0; p < n_points_; ++p) {
    const auto eliminated = eliminated_at(p);
    const Eigen::Map<const Eigen::VectorXd> right(&r[p * stride_], n);
    const Tensor6 initial = eliminated.topLeftCorner(6, n) * right;
    tensor::writable(stress, p).noalias() = moduli_[p] * initial;
  }
}

void MaterialTangent::solution(std::span<const double> r, std::span<const double> strain, std::span<double> z) const {
  const Index n = stride_;
#pragma omp parallel for schedule(static) if (n_points_ > numerics::parallel_tangents)
  for (std::size_t p = 0; p < n_points_; ++p) {
    const auto eliminated = eliminated_at(p);
    const Eigen::Map<const Eigen::VectorXd> right(&r[p * stride_], n);
    Eigen::Map<Eigen::VectorXd> result(&z[p * stride_], n);
    result.noalias() = eliminated.leftCols(n) * right;
    Tensor6 elastic = -result.head<6>();
    if (!strain.empty()) elastic += tensor::view(strain, p);
    const Tensor6 change = moduli_[p] * elastic;
    result.noalias() += eliminated.rightCols<6>() * change;
  }
}

}  // namespace creepcontact::creep
