#include <omp.h>

#include <Eigen/LU>
#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "element_block.hpp"
#include "node_entries.hpp"

namespace creepcontact::mechanics {

Eigen::MatrixXd ElementBlock::gradients(std::size_t e) const {
  const Index n = n_nodes_, inner = has_bubble() ? 3 : 0;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * n_coupled_ + inner, n_points_);
  for (std::size_t p = 0; p < n_points_; ++p) {
    const Matrix3 inverse = inverse_jacobian(e, p);
    const Eigen::Map<const Eigen::Matrix3Xd> table(&derivatives_[p * n_nodes_ * 3], 3, n);
    Eigen::Map<Eigen::Matrix3Xd>(result.col(p).data(), 3, n).noalias() = inverse.transpose() * table;
    if (has_bubble())
      result.col(p).tail<3>() =
          inverse.transpose() * bubble_derivatives_.row(p).transpose() - bubbles_[e].mean_gradient;
  }
  return result;
}

Eigen::MatrixXd ElementBlock::zz_strains(std::size_t e) const {
  if (!section_.is_axisymmetric() && !section_.has_axial_node()) return {};
  const Index n = n_nodes_, inner = has_bubble() ? 3 : 0;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * n_coupled_ + inner, n_points_);
  if (section_.has_axial_node()) {
    result.row(3 * n + 2).setConstant(1 / section_.axial_length);
    return result;
  }
  for (std::size_t p = 0; p < n_points_; ++p) {
    for (Index a = 0; a < n; ++a) result(3 * a, p) = shape_(a, p) * inverse_radius(e)[p];
    if (has_bubble()) result(3 * n, p) = bubble_values_[p] * inverse_radius(e)[p];
  }
  return result;
}

Eigen::MatrixXd ElementBlock::volumetric_gradients(std::size_t e, const Eigen::MatrixXd& divergence) const {
  const Eigen::MatrixXd basis = this->basis(e);
  const double kept = fits_mean_stress() ? unprojected_part(e) : basis.cols() == 0 ? 1.0 : 0.0;
  Eigen::MatrixXd result = kept * divergence;
  if (kept < 1) result += (1 - kept) * (divergence * weights(e).asDiagonal() * basis) * basis.transpose();
  return result;
}

Eigen::MatrixXd ElementBlock::condensed(const Eigen::MatrixXd& stiffness) const {
  if (!has_bubble()) return stiffness;
  const Index n = stiffness.rows() - 3;
  const Eigen::Matrix<double, 3, Eigen::Dynamic> coupling = stiffness.bottomLeftCorner(3, n);
  const Matrix3 own = stiffness.bottomRightCorner<3, 3>().inverse();
  return stiffness.topLeftCorner(n, n) - coupling.transpose() * own * coupling;
}

Eigen::MatrixXd ElementBlock::element_stiffness(std::size_t e, const ElasticState& elastic) const {
  if (!elastic.matrices.empty()) return element_stiffness(e, elastic.matrices);
  const Index n_p = n_points_;
  const Eigen::MatrixXd gradients = this->gradients(e), zz = zz_strains(e);
  const Eigen::MatrixXd divergence = zz.size() > 0 ? gradients + zz : gradients;
  const Eigen::MatrixXd volumetric = volumetric_gradients(e, divergence);
  const auto weight = weights(e);
  Eigen::VectorXd mu(n_p), bulk(n_p);
  for (Index p = 0; p < n_p; ++p) {
    const Moduli& h = elastic.at(start_.point + e * n_points_ + p);
    mu[p] = weight[p] * h.mu;
    const double lambda = has_plane_stress() ? 2 * h.mu * h.lambda / (h.lambda + 2 * h.mu) : h.lambda;
    bulk[p] = weight[p] * (lambda + 2.0 / 3.0 * h.mu);
  }
  const Eigen::MatrixXd shear = gradients * mu.asDiagonal() * gradients.transpose();
  Eigen::MatrixXd stiffness = volumetric * bulk.asDiagonal() * volumetric.transpose();
  if (zz.size() == 0)
    stiffness -= 2.0 / 3.0 * shear;
  else
    stiffness +=
        2 * zz * mu.asDiagonal() * zz.transpose() - 2.0 / 3.0 * divergence * mu.asDiagonal() * divergence.transpose();
  for (Index b = 0; b < gradients.rows(); b += 3) {
    for (Index a = 0; a < gradients.rows(); a += 3) {
      const auto from = shear.block<3, 3>(a, b);
      stiffness.block<3, 3>(a, b) += from.transpose() + from.trace() * Matrix3::Identity();
    }
  }
  return condensed(stiffness);
}

Matrix6 ElementBlock::in_section(const Matrix6& moduli) const {
  if (!has_plane_stress()) return moduli;
  return moduli - moduli.col(2) * moduli.row(2) / moduli(2, 2);
}

Eigen::MatrixXd ElementBlock::element_stiffness(std::size_t e, std::span<const Matrix6> moduli) const {
  const Index n_p = n_points_;
  constexpr double half_sqrt2 = tensor::sqrt2 / 2;
  const Eigen::MatrixXd gradients = this->gradients(e), zz = zz_strains(e);
  const Eigen::MatrixXd divergence = zz.size() > 0 ? gradients + zz : gradients;
  const Eigen::MatrixXd volumetric = volumetric_gradients(e, divergence);
  const auto weight = weights(e);
  const Index n_dofs = gradients.rows();
  // B of all points on top of each other: strain in Mandel order, one column per unknown.
  Eigen::MatrixXd strain = Eigen::MatrixXd::Zero(6 * n_p, n_dofs);
  for (Index p = 0; p < n_p; ++p) {
    for (Index a = 0; a < n_dofs; a += 3) {
      const Vector3 g = gradients.block<3, 1>(a, p), shear = half_sqrt2 * g;
      auto block = strain.block<6, 3>(6 * p, a);
      block.diagonal() = g;
      block(3, 0) = block(4, 2) = shear.y();
      block(3, 1) = block(5, 2) = shear.x();
      block(4, 1) = block(5, 0) = shear.z();
    }
  }
  for (Index p = 0; p < n_p && zz.size() > 0; ++p) strain.row(6 * p + 2) += zz.col(p).transpose();
  for (Index p = 0; p < n_p; ++p)
    strain.middleRows<3>(6 * p).rowwise() += (volumetric.col(p) - divergence.col(p)).transpose() / 3;
  Eigen::MatrixXd stress(6 * n_p, n_dofs);
  for (Index p = 0; p < n_p; ++p)
    stress.middleRows<6>(6 * p).noalias() =
        (weight[p] * in_section(moduli[start_.point + e * n_points_ + p])) * strain.middleRows<6>(6 * p);
  return condensed(strain.transpose() * stress);
}

namespace {

/// Sorted nodes not below `node` that share an element with it.
using NodeNeighbours = std::vector<std::vector<std::int64_t>>;

linalg::SparseMatrix pattern(const NodeNeighbours& neighbours) {
  const std::int64_t n = neighbours.size();
  linalg::SparseMatrix matrix(3 * n, 3 * n);
  std::int64_t* column_start = matrix.outerIndexPtr();
  for (std::int64_t b = 0; b < n; ++b) {
    const std::int64_t blocks = neighbours[b].size();
    for (std::int64_t j = 0; j < 3; ++j)
      column_start[3 * b + j + 1] = column_start[3 * b + j] + std::max<std::int64_t>(0, 3 * blocks - j);
  }
  matrix.resizeNonZeros(column_start[3 * n]);
#pragma omp parallel for schedule(static) if (neighbours.size() >= numerics::parallel_elements)
  for (std::int64_t b = 0; b < n; ++b) {
    for (std::int64_t j = 0; j < 3; ++j) {
      std::int64_t* row = matrix.innerIndexPtr() + column_start[3 * b + j];
      for (const std::int64_t a : neighbours[b])
        for (std::int64_t i = a == b ? j : 0; i < 3; ++i) *row++ = 3 * a + i;
    }
  }
  std::fill_n(matrix.valuePtr(), matrix.nonZeros(), 0.0);
  return matrix;
}

/// Adds the columns of an element matrix that belong to nodes with node % n_owners == owner.
void scatter(const Eigen::MatrixXd& element, std::span<const std::int64_t> nodes, const NodeNeighbours& neighbours,
             std::int64_t owner, std::int64_t n_owners, linalg::SparseMatrix& matrix) {
  for (std::size_t cb = 0; cb < nodes.size(); ++cb) {
    const std::int64_t b = nodes[cb];
    if (b % n_owners != owner) continue;
    const auto& list = neighbours[b];
    for (std::size_t ca = 0; ca < nodes.size(); ++ca) {
      const std::int64_t a = nodes[ca];
      if (a < b) continue;
      const std::int64_t position = std::lower_bound(list.begin(), list.end(), a) - list.begin();
      for (std::int64_t j = 0; j < 3; ++j) {
        // The block on the diagonal is a lower triangle: its columns, and what follows, begin j rows higher.
        double* value = matrix.valuePtr() + matrix.outerIndexPtr()[3 * b + j] + 3 * position - j;
        for (std::int64_t i = a == b ? j : 0; i < 3; ++i) value[i] += element(3 * ca + i, 3 * cb + j);
      }
    }
  }
}

}  // namespace

template <typename Moduli>
linalg::SparseMatrix Discretization::assemble(const Moduli& moduli) const {
  NodeNeighbours neighbours(n_nodes_);
#pragma omp parallel for schedule(dynamic, 256) if (n_nodes_ >= numerics::parallel_elements)
  for (std::size_t node = 0; node < n_nodes_; ++node) {
    auto& list = neighbours[node];
    for (const std::size_t entry : entries_->of(node))
      for (const std::int64_t other : coupled_nodes(element_of_entry(entry)))
        if (other >= static_cast<std::int64_t>(node)) list.push_back(other);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  linalg::SparseMatrix matrix = pattern(neighbours);

  // Element matrices of a chunk side by side, then every thread adds the columns of its own nodes, element by element:
  // no locks, and the order of summation is that of the elements.
  constexpr std::size_t chunk = 512;
  std::vector<Eigen::MatrixXd> elements(chunk);
  const int n_owners = n_elements_ >= numerics::parallel_elements ? omp_get_max_threads() : 1;
  for (const auto& block : blocks_) {
    for (std::size_t first = 0; first < block->n_elements(); first += chunk) {
      const std::size_t count = std::min(chunk, block->n_elements() - first);
#pragma omp parallel for schedule(static) if (n_owners > 1)
      for (std::size_t i = 0; i < count; ++i) elements[i] = block->element_stiffness(first + i, moduli);
#pragma omp parallel for schedule(static) if (n_owners > 1)
      for (int owner = 0; owner < n_owners; ++owner)
        for (std::size_t i = 0; i < count; ++i)
          scatter(elements[i], block->coupled_nodes(first + i), neighbours, owner, n_owners, matrix);
    }
  }
  return matrix;
}

linalg::SparseMatrix Discretization::stiffness(const ElasticState& elastic) const {
  return assemble(elastic);
}

linalg::SparseMatrix Discretization::stiffness(std::span<const Matrix6> moduli) const {
  return assemble(moduli);
}

}  // namespace creepcontact::mechanics
