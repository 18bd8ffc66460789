/// Products of dense matrices with vectors are those of Eigen.
#include "creepcontact/linalg/dense_products.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::linalg::test {
namespace {

class DenseProducts : public ::testing::TestWithParam<int> {
 protected:
  static void expect_near(const Eigen::VectorXd& found, const Eigen::VectorXd& exact) {
    ASSERT_EQ(found.size(), exact.size());
    EXPECT_LE((found - exact).norm(), 1e-13 * exact.norm() * std::sqrt(static_cast<double>(exact.size())));
  }
  Index n() const { return GetParam(); }
  Eigen::MatrixXd positive() const {
    const Eigen::MatrixXd half = Eigen::MatrixXd::Random(n(), n());
    return half * half.transpose() + static_cast<double>(n()) * Eigen::MatrixXd::Identity(n(), n());
  }
};

TEST_P(DenseProducts, AreThoseOfEigen) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(2 * n(), n());
  const Eigen::VectorXd x = Eigen::VectorXd::Random(n()), y = Eigen::VectorXd::Random(2 * n());
  Eigen::VectorXd sum = y;
  add_product(a, x, sum);
  expect_near(sum, y + a * x);
  expect_near(transposed_product(a, y), a.transpose() * y);
  Eigen::VectorXd whole = Eigen::VectorXd::Random(2 * n() + 3), exact = whole;
  exact.tail(2 * n()) += a * x;
  add_product(a, x, whole.tail(2 * n()));
  expect_near(whole, exact);
}

TEST_P(DenseProducts, ReadOneTriangle) {
  const Eigen::MatrixXd whole = positive();
  Eigen::MatrixXd lower = whole;
  lower.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::VectorXd x = Eigen::VectorXd::Random(n());
  expect_near(symmetric_product(lower, x), whole * x);
  const Eigen::LLT<Eigen::MatrixXd> llt(whole);
  Eigen::MatrixXd factor = llt.matrixLLT();
  factor.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
  expect_near(solution(factor, whole * x), x);
  Eigen::VectorXd forward = x;
  substitute_forward(factor, forward);
  expect_near(llt.matrixL() * forward, x);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Random(n(), 3), solved = columns;
  substitute_forward_in_all(factor, solved);
  for (Index j = 0; j < 3; ++j) expect_near(llt.matrixL() * solved.col(j), columns.col(j));
}

TEST_P(DenseProducts, OfColumns) {
  const Eigen::MatrixXd columns = Eigen::MatrixXd::Random(2 * n(), n());
  const Eigen::MatrixXd found = products_of_columns(columns), exact = columns.transpose() * columns;
  ASSERT_EQ(found.rows(), n());
  EXPECT_EQ(found, found.transpose());
  EXPECT_LE((found - exact).lpNorm<Eigen::Infinity>(), 1e-12 * exact.lpNorm<Eigen::Infinity>());
}

INSTANTIATE_TEST_SUITE_P(Sizes, DenseProducts, ::testing::Values(0, 1, 7, 31, 32, 33, 100, 261));

}  // namespace
}  // namespace creepcontact::linalg::test
