#pragma once
/// Which rows of a sparse matrix are linearly independent, and how the others follow from them.

#include <Eigen/SparseCore>
#include <vector>

namespace creepcontact::linalg {

struct IndependentRows {
  std::vector<int> independent, dependent;  ///< row numbers, ascending
  /// dependent.size() x independent.size(): row dependent[i] = sum over j of combination(i, j) row independent[j]
  Eigen::MatrixXd combination;
};

/// Rows that vanish are dependent. @param rows  of comparable size; a part of 1e-9 counts as nothing
/// Cost: a sparse QR factorisation of the transpose.
IndependentRows independent_rows(const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows);

}  // namespace creepcontact::linalg
