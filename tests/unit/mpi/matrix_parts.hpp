#pragma once
/// Matrices and vectors as sums of what the processes have of them.

#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/team.hpp"
#include "unit/linalg/matrices.hpp"

namespace creepcontact::mpi::testing {

/// What one process adds to a matrix: its share of every entry, so that all have entries of all columns.
inline linalg::SparseMatrix shared_out(const linalg::SparseMatrix& whole, const Team& team) {
  linalg::SparseMatrix own = whole;
  own.coeffs() /= team.size();
  return own;
}

/// Or entries of every n-th column, which other processes do not know.
inline linalg::SparseMatrix dealt_out(const linalg::SparseMatrix& whole, const Team& team) {
  linalg::SparseMatrix own = whole;
  own.prune([&](auto, auto column, double) { return column % team.size() == team.rank(); });
  own.makeCompressed();
  return own;
}

/// The whole right-hand side on process 0 where it has the unknowns, else on the process that has.
inline std::vector<double> part(const Eigen::VectorXd& whole, const linalg::SparseMatrix& own, const Team& team) {
  std::vector<double> has(whole.size(), 0.0), result(whole.size(), 0.0);
  for (std::int64_t column = 0; column < own.outerSize(); ++column)
    for (linalg::SparseMatrix::InnerIterator entry(own, column); entry; ++entry) has[entry.row()] = has[column] = 1;
  std::vector<double> owners = has;
  team.sum(owners);
  for (Index i = 0; i < whole.size(); ++i)
    if (has[i] > 0) result[i] = whole[i] / owners[i];
  return result;
}

}  // namespace creepcontact::mpi::testing
