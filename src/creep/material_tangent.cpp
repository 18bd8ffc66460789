#include "creepcontact/creep/material_tangent.hpp"

#include <Eigen/LU>
#include <optional>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/numerics/parallel.hpp"
#include "linear_elimination.hpp"

namespace creepcontact::creep {
namespace {

Matrix6 compliance(const mechanics::ElasticState& elastic, std::size_t point) {
  if (!elastic.matrices.empty()) return linalg::inverse_of_positive(elastic.matrices[point]);
  const material::Moduli& h = elastic.at(point);
  return isotropic(1 / (2 * h.mu), 1 / (3 * h.lambda + 2 * h.mu));
}

/// D, symmetrised. @param creep  N_c
Matrix6 modulus(const mechanics::ElasticState& elastic, std::size_t point, const Matrix6& creep) {
  const Matrix6 inverse = linalg::inverse(Matrix6(compliance(elastic, point) + creep));
  return 0.5 * (inverse + inverse.transpose());
}

/// Calls use(p, elimination) for all points of linear laws. One elimination serves all points that do not differ.
template <typename Use>
void for_each_linear_point(const MaterialPoints& points, double gamma, const PointsState& at, const Use& use) {
  std::optional<LinearElimination> of_all;
  if (points.is_uniform(at)) of_all.emplace(points, 0, gamma, at);
  numerics::for_each_index(points.size(), numerics::parallel_tangents, [&](std::size_t p) {
    if (of_all)
      use(p, *of_all);
    else
      use(p, LinearElimination(points, p, gamma, at));
  });
}

}  // namespace

struct MaterialTangent::Work {
  explicit Work(Index stride) : unit(stride), by_state(stride, stride), by_stress(stride, 6) {}
  Eigen::VectorXd unit;
  Index first = 0;                         // of the state variables that rates depend on
  Eigen::MatrixXd by_state;                // A
  Eigen::Matrix<double, -1, 6> by_stress;  // C
  Eigen::MatrixXd own;                     // the part of M that has to be inverted
  Eigen::PartialPivLU<Eigen::MatrixXd> elimination;
  Eigen::MatrixXd columns;  // [gamma C, r]
};

MaterialTangent::MaterialTangent(const MaterialPoints& points)
    : points_(points), n_points_(points.size()), stride_(points.stride()) {}

Index MaterialTangent::first_state(std::size_t p, const PointsState& at, Work& work) const {
  const Tensor6 no_stress = Tensor6::Zero();
  work.unit.setZero();
  // A direction that no law with a derivative could be insensitive to by symmetry.
  work.unit.head<6>() << 0.4361, -0.8273, 0.2918, 0.6157, -0.3574, 0.9139;
  points_.derivative_at(p, at, {.stress = {no_stress.data(), 6}, .state = {work.unit.data(), stride_}},
                        {work.by_state.col(0).data(), stride_});
  return work.by_state.col(0).isZero(0) ? 6 : 0;
}

void MaterialTangent::linearize(std::size_t p, const PointsState& at, Work& work) const {
  const Index n = stride_;
  Tensor6 stress = Tensor6::Zero();
  const PointsChange change{.stress = {stress.data(), 6}, .state = {work.unit.data(), stride_}};
  work.first = first_state(p, at, work);
  for (Index j = work.first; j < n; ++j) {
    work.unit = Eigen::VectorXd::Unit(n, j);
    points_.derivative_at(p, at, change, {work.by_state.col(j).data(), stride_});
  }
  work.unit.setZero();
  for (Index j = 0; j < 6; ++j) {
    stress = Tensor6::Unit(j);
    points_.derivative_at(p, at, change, {work.by_stress.col(j).data(), stride_});
  }
}

/// columns = M^-1 columns. If no rate depends on the creep strain, M is the identity there.
void MaterialTangent::eliminate(double gamma, Work& work, Eigen::Ref<Eigen::MatrixXd> columns) {
  const Index first = work.first, own = columns.rows() - first;
  const auto by_own = work.by_state.rightCols(own);
  if (by_own.isZero(0)) return;  // secondary creep
  // M = [I, -gamma A_c; 0, I - gamma A_i]: only the second block is inverted.
  work.own = -gamma * by_own.bottomRows(own);
  work.own.diagonal().array() += 1;
  work.elimination.compute(work.own);
  columns.bottomRows(own) = work.elimination.solve(columns.bottomRows(own)).eval();
  if (first > 0) columns.topRows(first) += (gamma * by_own.topRows(first)).lazyProduct(columns.bottomRows(own));
}

void MaterialTangent::prepare_point(std::size_t p, double gamma, const PointsState& at, Work& work) {
  const Index n = stride_;
  Eigen::Map<Eigen::MatrixXd> eliminated = eliminated_at(p);
  linearize(p, at, work);
  eliminated.leftCols(n).setIdentity();
  eliminated.rightCols<6>() = gamma * work.by_stress;
  eliminate(gamma, work, eliminated.rightCols(n - work.first + 6));
  moduli_[p] = modulus(at.elastic, p, eliminated.topRightCorner<6, 6>());
}

void MaterialTangent::prepare(double gamma, const PointsState& given) {
  PointsState at = given;
  const auto prepared = points_.prepare(at, true);
  at.prepared = &prepared;
  moduli_.resize(n_points_);
  eliminated_.resize(n_points_ * stride_ * (stride_ + 6));  // far more than the state: not before it is needed
  if (points_.is_linear())
    return for_each_linear_point(points_, gamma, at, [&](std::size_t p, const LinearElimination& linear) {
      linear.write(eliminated_at(p));
      moduli_[p] = linear.modulus();
    });
#pragma omp parallel if (n_points_ > numerics::parallel_tangents)
  {
    Work work(stride_);
#pragma omp for schedule(static)
    for (std::size_t p = 0; p < n_points_; ++p) prepare_point(p, gamma, at, work);
  }
}

void MaterialTangent::solve_points(double gamma, const PointsState& given, std::span<const double> r,
                                   std::span<double> z) const {
  PointsState at = given;
  const auto prepared = points_.prepare(at, true);
  at.prepared = &prepared;
  if (points_.is_linear())
    return for_each_linear_point(points_, gamma, at, [&](std::size_t p, const LinearElimination& linear) {
      linear.solve(r.subspan(p * stride_, stride_), z.subspan(p * stride_, stride_));
    });
  const Index n = stride_;
#pragma omp parallel if (n_points_ > numerics::parallel_tangents)
  {
    Work work(stride_);
    work.columns.resize(n, 7);
#pragma omp for schedule(static)
    for (std::size_t p = 0; p < n_points_; ++p) {
      linearize(p, at, work);
      work.columns.leftCols<6>() = gamma * work.by_stress;
      work.columns.col(6) = Eigen::Map<const Eigen::VectorXd>(&r[p * stride_], n);
      eliminate(gamma, work, work.columns);
      const Tensor6 change =
          -(modulus(at.elastic, p, work.columns.topLeftCorner<6, 6>()) * work.columns.col(6).head<6>());
      Eigen::Map<Eigen::VectorXd>(&z[p * stride_], n) =
          work.columns.col(6) + work.columns.leftCols<6>().lazyProduct(change);
    }
  }
}

Eigen::Map<Eigen::MatrixXd> MaterialTangent::eliminated_at(std::size_t p) {
  const Index n = stride_;
  return {&eliminated_[p * stride_ * (stride_ + 6)], n, n + 6};
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
