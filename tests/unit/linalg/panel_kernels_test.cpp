#include "../../../src/linalg/panel_kernels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "creepcontact/base/index.hpp"

namespace creepcontact::linalg {
namespace {

template <typename Entry>
using Dense = Eigen::Matrix<Entry, Eigen::Dynamic, Eigen::Dynamic>;

/// Every number of columns up to two strips of eight, and of rows about the widths of vectors and of a chunk.
template <typename Entry>
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
  Dense<Entry> matrix(Index rows, Index columns) {
    Dense<Entry> result(rows, columns);
    for (Index i = 0; i < result.size(); ++i) result.data()[i] = static_cast<Entry>(uniform_(random_));
    return result;
  }
  Eigen::VectorXd vector(Index size) {
    Eigen::VectorXd result(size);
    for (double& value : result) value = uniform_(random_);
    return result;
  }
  /// A well-conditioned lower triangle on top of other rows; NaN above the diagonal, which must not be read.
  Dense<Entry> trapezoid(Index below, Index columns) {
    Dense<Entry> result = matrix(columns + below, columns) / static_cast<Entry>(4);
    for (Index j = 0; j < columns; ++j) {
      result(j, j) += static_cast<Entry>(2);
      for (Index i = 0; i < j; ++i) result(i, j) = std::numeric_limits<Entry>::quiet_NaN();
    }
    return result;
  }
  static Eigen::MatrixXd triangle(const Dense<Entry>& l) {
    return Eigen::MatrixXd(l.topRows(l.cols()).template cast<double>().template triangularView<Eigen::Lower>());
  }
  static Panel<Entry> panel(const Dense<Entry>& l) { return {l.data(), l.rows(), l.rows(), l.cols()}; }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};
using Entries = ::testing::Types<double, float>;
TYPED_TEST_SUITE(PanelKernels, Entries);

TYPED_TEST(PanelKernels, Products) {
  this->for_each_shape([&](Index rows, Index columns) {
    const Dense<TypeParam> l = this->matrix(rows, columns);
    const Eigen::MatrixXd exact = l.template cast<double>();
    const Eigen::VectorXd x = this->vector(columns), y = this->vector(rows);
    Eigen::VectorXd to = y;
    subtract_product(this->panel(l), x.data(), to.data());
    EXPECT_LE((to - (y - exact * x)).template lpNorm<Eigen::Infinity>(), 1e-14);
    to = x;
    subtract_transposed_product(this->panel(l), y.data(), to.data());
    EXPECT_LE((to - (x - exact.transpose() * y)).template lpNorm<Eigen::Infinity>(), 1e-12);
  });
}

TYPED_TEST(PanelKernels, Substitutions) {
  this->for_each_shape([&](Index below, Index columns) {
    const Dense<TypeParam> l = this->trapezoid(below, columns);
    const Eigen::MatrixXd top = this->triangle(l), rest = l.bottomRows(below).template cast<double>();
    const Eigen::VectorXd x = this->vector(columns + below);
    Eigen::VectorXd exact = x, to = x;
    exact.head(columns) = top.triangularView<Eigen::Lower>().solve(x.head(columns));
    exact.tail(below) -= rest * exact.head(columns);
    eliminate(this->panel(l), to.data());
    EXPECT_LE((to - exact).template lpNorm<Eigen::Infinity>(), 1e-12);
    exact = to = x;
    exact.head(columns) = top.transpose().triangularView<Eigen::Upper>().solve(
        Eigen::VectorXd(x.head(columns) - rest.transpose() * x.tail(below)));
    substitute(this->panel(l), to.data());
    EXPECT_LE((to - exact).template lpNorm<Eigen::Infinity>(), 1e-11);
  });
}

}  // namespace
}  // namespace creepcontact::linalg
