#include "factored_flexibility.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace creepcontact::contact {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double min_pivot = 1e-12;
constexpr double least_compliance = 1e-3;  // of the flexibility, in rows next to those of a gasket

/// K restricted to the unknowns that contact rows touch, both triangles. @param place  of each unknown, or -1
Sparse restricted(const linalg::SparseMatrix& lower, const std::vector<int>& position, int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::int64_t column = 0; column < lower.outerSize(); ++column) {
    const int j = position[column];
    if (j < 0) continue;
    for (linalg::SparseMatrix::InnerIterator it(lower, column); it; ++it) {
      const int i = position[it.row()];
      if (i < 0) continue;
      entries.emplace_back(i, j, it.value());
      if (i != j) entries.emplace_back(j, i, it.value());
    }
  }
  Sparse result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Entries of a sparse matrix in chosen rows and columns.
Sparse submatrix(const Sparse& matrix, const std::vector<int>& chosen) {
  std::vector<int> position(matrix.rows(), -1);
  for (std::size_t k = 0; k < chosen.size(); ++k) position[chosen[k]] = static_cast<int>(k);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    for (Sparse::InnerIterator it(matrix, chosen[k]); it; ++it)
      if (const int i = position[it.row()]; i >= 0) entries.emplace_back(i, static_cast<int>(k), it.value());
  const auto n = static_cast<int>(chosen.size());
  Sparse result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

struct FactoredFlexibility::Lumped {
  std::vector<int> rows;  // in all pairs, where the body is the slave
  Sparse stiffness;       // B K B^T
  Sparse square;          // B B^T
};

FactoredFlexibility::FactoredFlexibility(std::span<mechanics::FactoredBody> bodies,
                                         std::span<const mechanics::BodyConditions> at,
                                         const std::vector<BodyRows>& rows, int n_rows)
    : bodies_(bodies), rows_(rows), diagonal_(Eigen::VectorXd::Zero(n_rows)) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyRows& own = rows[b];
    work_.emplace_back(own.reduced.cols());
    if (own.rows.empty()) continue;
    std::vector<int> position(own.reduced.cols(), -1);
    int n_touched = 0;
    for (int r = 0; r < own.reduced.outerSize(); ++r)
      for (RowMatrix::InnerIterator it(own.reduced, r); it; ++it)
        if (position[it.col()] < 0) position[it.col()] = n_touched++;
    std::vector<Eigen::Triplet<double>> entries;
    for (int r = 0; r < own.reduced.outerSize(); ++r)
      for (RowMatrix::InnerIterator it(own.reduced, r); it; ++it)
        entries.emplace_back(r, position[it.col()], it.value());
    Sparse touched(static_cast<int>(own.rows.size()), n_touched);
    touched.setFromTriplets(entries.begin(), entries.end());

    const Sparse stiffness =
        touched * restricted(bodies[b].stiffness(at[b]), position, n_touched) * touched.transpose();
    const Sparse square = touched * touched.transpose();
    // Rows that the body cannot follow (held there) are none of its own but for rounding.
    const double least = min_pivot * square.diagonal().maxCoeff();
    Lumped lumped;
    std::vector<int> as_slave;
    for (int r = 0; r < std::ssize(own.rows); ++r) {
      const double s = square.coeff(r, r), k = stiffness.coeff(r, r);
      if (!(s > least && k > 0)) continue;
      diagonal_[own.rows[r]] += s * s / k;  // <= F_ii, by Cauchy and Schwarz
      if (!own.is_slaves[r]) continue;
      as_slave.push_back(r);
      lumped.rows.push_back(own.rows[r]);
    }
    lumped.stiffness = submatrix(stiffness, as_slave);
    lumped.square = submatrix(square, as_slave);
    lumped_.push_back(std::move(lumped));
  }
}

FactoredFlexibility::~FactoredFlexibility() = default;

Eigen::VectorXd FactoredFlexibility::gaps(const Eigen::VectorXd& multiplier) const {
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(diagonal_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyRows& own = rows_[b];
    if (own.rows.empty()) continue;
    Eigen::Map<Eigen::VectorXd> u(work_[b].data(), own.reduced.cols());
    u.noalias() = own.reduced.transpose() * multiplier(own.rows);
    bodies_[b].solver().forward(work_[b], work_[b]);
    bodies_[b].solver().backward(work_[b], work_[b]);
    gap(own.rows) += own.reduced * u;
  }
  ++n_products_;
  return gap;
}

std::unique_ptr<Preconditioner> FactoredFlexibility::preconditioner(const std::vector<int>& set,
                                                                    const Eigen::VectorXd& compliance) const {
  struct Block {
    std::vector<int> positions;  // in the set
    Sparse stiffness;
    Eigen::SimplicialLDLT<Sparse> square;
    Eigen::VectorXd layer;                  // 1 / compliance; empty without gaskets
    Eigen::SimplicialLDLT<Sparse> layered;  // B K B^T + D C^-1 D, with D = B B^T

    Eigen::VectorXd multipliers(const Eigen::VectorXd& gaps) const {
      if (layer.size() == 0) {
        const Eigen::VectorXd displacement = square.solve(gaps);
        const Eigen::VectorXd force = stiffness * displacement;
        return square.solve(force);
      }
      const Eigen::VectorXd pressed = layer.cwiseProduct(gaps);
      const Eigen::VectorXd displacement = layered.solve(coupling * pressed);
      return pressed - layer.cwiseProduct(coupling * displacement);
    }
    Sparse coupling;  // D
  };
  class LumpedDirichlet final : public Preconditioner {
   public:
    Eigen::VectorXd multipliers(const Eigen::VectorXd& gaps) const override {
      Eigen::VectorXd result = rest.cwiseProduct(gaps);
      for (const auto& block : blocks) {
        const Eigen::VectorXd closing = block->multipliers(gaps(block->positions));
        result(block->positions) = closing;  // the solver permutes in place: no indexed target
      }
      return result;
    }
    std::vector<std::unique_ptr<Block>> blocks;
    Eigen::VectorXd rest;  // 1/diag F of rows in no block
  };
  auto result = std::make_unique<LumpedDirichlet>();
  result->rest = (diagonal_(set).cwiseMax(1e-14 * diagonal_.maxCoeff()) + compliance).cwiseInverse();
  for (const Lumped& lumped : lumped_) {
    auto block = std::make_unique<Block>();
    std::vector<int> own;
    for (std::size_t k = 0; k < set.size(); ++k) {
      const auto found = std::lower_bound(lumped.rows.begin(), lumped.rows.end(), set[k]);
      if (found == lumped.rows.end() || *found != set[k]) continue;
      block->positions.push_back(static_cast<int>(k));
      own.push_back(static_cast<int>(found - lumped.rows.begin()));
    }
    if (own.empty()) continue;
    block->stiffness = submatrix(lumped.stiffness, own);
    const Sparse square = submatrix(lumped.square, own);
    const Eigen::VectorXd layer = compliance(block->positions);
    if (layer.isZero(0)) {
      block->square.compute(square);
      if (block->square.info() != Eigen::Success) continue;
    } else {
      std::vector<int> rows;
      for (const int position : block->positions) rows.push_back(set[static_cast<std::size_t>(position)]);
      block->layer = layer.cwiseMax(least_compliance * diagonal_(rows)).cwiseInverse();
      block->coupling = square;
      const Sparse layered = block->stiffness + Sparse(square * block->layer.asDiagonal() * square);
      block->layered.compute(layered);
      if (block->layered.info() != Eigen::Success) continue;
    }
    result->blocks.push_back(std::move(block));
  }
  return result;
}

}  // namespace creepcontact::contact
