#include "creepcontact/linalg/independent_rows.hpp"

#include <Eigen/SparseQR>
#include <algorithm>
#include <utility>

namespace creepcontact::linalg {
namespace {

constexpr double min_row_norm = 1e-9;  // of the largest row

using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// The transpose without the rows that are empty: a few hundred equations touch few of a million unknowns.
Columns compressed_transpose(const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows) {
  std::vector<int> number(static_cast<std::size_t>(rows.cols()), -1);
  int n_used = 0;
  std::vector<Eigen::Triplet<double>> entries;
  for (int r = 0; r < rows.outerSize(); ++r)
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(rows, r); it; ++it) {
      if (it.value() == 0) continue;
      int& own = number[static_cast<std::size_t>(it.col())];
      if (own < 0) own = n_used++;
      entries.emplace_back(own, r, it.value());
    }
  Columns transpose(std::max(n_used, 1), rows.rows());
  transpose.setFromTriplets(entries.begin(), entries.end());
  transpose.makeCompressed();
  return transpose;
}

}  // namespace

IndependentRows independent_rows(const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows) {
  IndependentRows result;
  if (rows.rows() == 0) return result;
  const Columns transpose = compressed_transpose(rows);
  double largest = 0;
  for (int c = 0; c < transpose.outerSize(); ++c) largest = std::max(largest, transpose.col(c).norm());
  if (largest == 0) {
    for (int r = 0; r < rows.rows(); ++r) result.dependent.push_back(r);
    result.combination.setZero(rows.rows(), 0);
    return result;
  }
  Eigen::SparseQR<Columns, Eigen::COLAMDOrdering<int>> factors;
  factors.setPivotThreshold(min_row_norm * largest);
  factors.compute(transpose);
  const Eigen::Index rank = factors.rank(), n_rows = rows.rows();
  const Eigen::MatrixXd upper = Eigen::MatrixXd(factors.matrixR()).topRows(rank);
  const Eigen::MatrixXd left =
      upper.leftCols(rank).triangularView<Eigen::Upper>().solve(upper.rightCols(n_rows - rank)).transpose();
  const auto& order = factors.colsPermutation().indices();
  std::vector<std::pair<int, Eigen::Index>> kept, others;  // row, and its place in the factors
  for (Eigen::Index i = 0; i < n_rows; ++i)
    (i < rank ? kept : others).emplace_back(static_cast<int>(order[i]), i < rank ? i : i - rank);
  std::ranges::sort(kept);
  std::ranges::sort(others);
  for (const auto& [row, place] : kept) result.independent.push_back(row);
  for (const auto& [row, place] : others) result.dependent.push_back(row);
  result.combination.resize(std::ssize(others), std::ssize(kept));
  for (std::size_t i = 0; i < others.size(); ++i)
    for (std::size_t j = 0; j < kept.size(); ++j)
      result.combination(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          left(others[i].second, kept[j].second);
  return result;
}

}  // namespace creepcontact::linalg
