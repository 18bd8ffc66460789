#include "creepcontact/linalg/independent_rows.hpp"

#include <gtest/gtest.h>

namespace creepcontact::linalg {
namespace {

using RowSparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

RowSparse sparse(const Eigen::MatrixXd& dense) {
  return dense.sparseView();
}

TEST(IndependentRows, OthersAreCombinationsOfThem) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(6, 40);
  rows.row(0)[3] = 1;
  rows.row(0)[30] = -1;
  rows.row(1)[30] = 1;
  rows.row(1)[7] = -1;
  rows.row(2) = rows.row(0) + rows.row(1);
  rows.row(4)[12] = 5;
  rows.row(5) = 3 * rows.row(2) - 2 * rows.row(4);
  const IndependentRows found = independent_rows(sparse(rows));
  ASSERT_EQ(found.independent.size(), 3U);
  ASSERT_EQ(found.dependent.size(), 3U);  // one of the first three, the empty one, and the last or its parts
  for (std::size_t i = 0; i < 3; ++i) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(40);
    for (std::size_t j = 0; j < 3; ++j)
      sum += found.combination(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
             rows.row(found.independent[j]);
    EXPECT_NEAR((sum - rows.row(found.dependent[i])).norm(), 0, 1e-12);
  }
}

TEST(IndependentRows, NoRowsAndEmptyOnes) {
  EXPECT_TRUE(independent_rows(RowSparse(0, 5)).independent.empty());
  const IndependentRows empty = independent_rows(RowSparse(2, 5));
  EXPECT_EQ(empty.dependent, (std::vector<int>{0, 1}));
  EXPECT_EQ(empty.combination.rows(), 2);
  EXPECT_EQ(empty.combination.cols(), 0);
}

}  // namespace
}  // namespace creepcontact::linalg
