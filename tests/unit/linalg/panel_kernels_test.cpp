#include "../../../src/linalg/panel_kernels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <random>
#include <vector>

#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg {
namespace {

/// Every number of columns up to two strips of eight, and of rows about the widths of vectors and of a chunk.
class PanelKernels : public ::testing::Test {
 protected:
  static constexpr Index most_columns = 17;

  template <typename Check>
  void for_each_shape(const Check& check) {
    for (Index columns = 1; columns <= most_columns; ++columns)
      for (const Index rows : {0, 1, 3, 4, 7, 8, 9, 13, 30, 700, 4100}) {
        SCOPED_TRACE(::testing::Message() << rows << " x " << columns);
        check(rows, columns);
      }
  }
  Eigen::MatrixXd matrix(Index rows, Index columns) {
    Eigen::MatrixXd result(rows, columns);
    for (Index i = 0; i < result.size(); ++i) result.data()[i] = uniform_(random_);
    return result;
  }
  Eigen::VectorXd vector(Index size) {
    Eigen::VectorXd result(size);
    for (double& value : result) value = uniform_(random_);
    return result;
  }
  /// A well-conditioned lower triangle on top of other rows; NaN above the diagonal, which must not be read.
  Eigen::MatrixXd trapezoid(Index below, Index columns) {
    Eigen::MatrixXd result = matrix(columns + below, columns) / 4;
    for (Index j = 0; j < columns; ++j) {
      result(j, j) += 2;
      for (Index i = 0; i < j; ++i) result(i, j) = std::numeric_limits<double>::quiet_NaN();
    }
    return result;
  }
  static Eigen::MatrixXd triangle(const Eigen::MatrixXd& l) {
    return Eigen::MatrixXd(l.topRows(l.cols()).triangularView<Eigen::Lower>());
  }
  static Panel panel(const Eigen::MatrixXd& l) { return {l.data(), l.rows(), l.rows(), l.cols()}; }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST_F(PanelKernels, Products) {
  for_each_shape([&](Index rows, Index columns) {
    const Eigen::MatrixXd l = matrix(rows, columns);
    const Eigen::VectorXd x = vector(columns), y = vector(rows);
    Eigen::VectorXd to = y;
    subtract_product(panel(l), x.data(), to.data());
    EXPECT_LE((to - (y - l * x)).lpNorm<Eigen::Infinity>(), 1e-14);
    to = x;
    subtract_transposed_product(panel(l), y.data(), to.data());
    EXPECT_LE((to - (x - l.transpose() * y)).lpNorm<Eigen::Infinity>(), 1e-12);
  });
}

TEST_F(PanelKernels, Substitutions) {
  for_each_shape([&](Index below, Index columns) {
    const Eigen::MatrixXd l = trapezoid(below, columns);
    const Eigen::MatrixXd top = triangle(l), rest = l.bottomRows(below);
    const Eigen::VectorXd x = vector(columns + below);
    Eigen::VectorXd exact = x, to = x;
    exact.head(columns) = top.triangularView<Eigen::Lower>().solve(x.head(columns));
    exact.tail(below) -= rest * exact.head(columns);
    eliminate(panel(l), to.data());
    EXPECT_LE((to - exact).lpNorm<Eigen::Infinity>(), 1e-12);
    exact = to = x;
    exact.head(columns) = top.transpose().triangularView<Eigen::Upper>().solve(
        Eigen::VectorXd(x.head(columns) - rest.transpose() * x.tail(below)));
    substitute(panel(l), to.data());
    EXPECT_LE((to - exact).lpNorm<Eigen::Infinity>(), 1e-11);
  });
}

TEST_F(PanelKernels, SeveralVectorsAreThoseOfOneAtATime) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (const auto& [given, padding] : {std::pair{1, 1}, {2, 4}, {8, 8}, {9, 12}, {17, 20}})
    EXPECT_EQ(padded(static_cast<std::size_t>(given)), static_cast<std::size_t>(padding));
  for (const std::size_t vectors : {4, 8, 12, 16, 20})
    for_each_shape([&](Index rows, Index columns) {
      const Index n = static_cast<Index>(vectors);
      const Eigen::MatrixXd l = matrix(rows, columns), t = trapezoid(rows, columns);
      const Rows x = matrix(columns, n), y = matrix(rows, n), both = matrix(columns + rows, n);
      Rows product = y, transposed = x, eliminated = both, substituted = both;
      subtract_product(panel(l), x.data(), product.data(), vectors);
      subtract_transposed_product(panel(l), y.data(), transposed.data(), vectors);
      eliminate(panel(t), eliminated.data(), vectors);
      substitute(panel(t), substituted.data(), vectors);
      for (Index v = 0; v < n; ++v) {
        const Eigen::VectorXd of_x = x.col(v), of_y = y.col(v);
        Eigen::VectorXd one = of_y;
        subtract_product(panel(l), of_x.data(), one.data());
        EXPECT_LE((product.col(v) - one).lpNorm<Eigen::Infinity>(), 1e-13);
        one = of_x;
        subtract_transposed_product(panel(l), of_y.data(), one.data());
        EXPECT_LE((transposed.col(v) - one).lpNorm<Eigen::Infinity>(), 1e-12);
        one = both.col(v);
        eliminate(panel(t), one.data());
        EXPECT_LE((eliminated.col(v) - one).lpNorm<Eigen::Infinity>(), 1e-12);
        one = both.col(v);
        substitute(panel(t), one.data());
        EXPECT_LE((substituted.col(v) - one).lpNorm<Eigen::Infinity>(), 1e-11);
      }
    });
}

TEST_F(PanelKernels, TheNumberOfOtherVectorsChangesNoBit) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (const std::size_t vectors : {16, 24})
    for_each_shape([&](Index rows, Index columns) {
      const Eigen::MatrixXd l = matrix(rows, columns), t = trapezoid(rows, columns);
      const Rows x = matrix(columns, 24), y = matrix(rows, 24), both = matrix(columns + rows, 24);
      const auto first_eight = [&](std::size_t of) {
        const Index n = static_cast<Index>(of);
        const Rows from_x = x.leftCols(n), from_y = y.leftCols(n);
        std::array<Rows, 4> results{from_y, from_x, both.leftCols(n), both.leftCols(n)};
        subtract_product(panel(l), from_x.data(), results[0].data(), of);
        subtract_transposed_product(panel(l), from_y.data(), results[1].data(), of);
        eliminate(panel(t), results[2].data(), of);
        substitute(panel(t), results[3].data(), of);
        for (Rows& result : results) result = Rows(result.leftCols(8));
        return results;
      };
      EXPECT_EQ(first_eight(vectors), first_eight(8));
    });
}

}  // namespace
}  // namespace creepcontact::linalg
