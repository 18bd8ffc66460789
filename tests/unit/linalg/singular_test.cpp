#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "creepcontact/base/index.hpp"
#include "matrices.hpp"

namespace creepcontact::linalg {
namespace singular_tests {
namespace {

using testing::Problem;
using Indices = std::vector<std::int64_t>;

/// What factorize() reports; row -1 if it reports nothing.
SingularMatrix report(const Problem& problem, const Indices& trailing = {}) {
  SupernodalCholesky solver(problem.lower, problem.node_of, trailing);
  try {
    solver.factorize(problem.lower);
  } catch (const SingularMatrix& singular) {
    EXPECT_EQ(solver.rcond(), 0);
    return singular;
  }
  return {};
}

TEST(Singular, ARegularMatrixIsNot) {
  EXPECT_EQ(report(testing::grid(4)).row, -1);
}

TEST(Singular, ZeroRowIsNamed) {
  for (const std::int64_t row : {0, 50, 191}) {
    for (const Indices& trailing : {Indices{}, Indices{row}, Indices{20, 100}}) {
      Problem problem = testing::grid(4);
      problem.lower.prune([&](std::int64_t i, std::int64_t j, double) { return (i != row && j != row) || i == j; });
      problem.lower.coeffRef(row, row) = 0;
      EXPECT_EQ(report(problem, trailing).row, row);
    }
  }
}

TEST(Singular, NegativePivotIsNamed) {
  Problem problem = testing::grid(4);
  problem.lower.coeffRef(77, 77) = -5;
  EXPECT_EQ(report(problem, {77}).row, 77);
}

TEST(Singular, NearlyZeroPivotIsNamedWithTheCondition) {
  Problem problem = testing::grid(4);
  problem.lower.prune([](std::int64_t i, std::int64_t j, double) { return (i != 77 && j != 77) || i == j; });
  problem.lower.coeffRef(77, 77) = 1e-14;
  const SingularMatrix singular = report(problem);
  EXPECT_EQ(singular.row, 77);
  EXPECT_GT(singular.rcond, 0);
  EXPECT_LT(singular.rcond, 1e-12);
}

TEST(Singular, BodyFreeToMoveAmongHeldOnesIsFound) {
  // Three chains of springs; the middle one is not held. Round-off decides whether its last pivot is positive.
  const Index n = 40;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (Index body = 0; body < 3; ++body) {
    for (Index i = 0; i + 1 < n; ++i) {
      const double stiffness = 1 + 0.37 * static_cast<double>(i % 7);
      dense.block<2, 2>(body * n + i, body * n + i) += stiffness * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
    }
    if (body != 1) dense(body * n, body * n) += 1;
  }
  Problem problem{testing::lower_of(dense), {}};
  for (Index i = 0; i < 3 * n; ++i) problem.node_of.push_back(i);
  for (const Indices& trailing : {Indices{}, Indices{5, 45, 100}}) {
    const SingularMatrix singular = report(problem, trailing);
    EXPECT_GE(singular.row, n);
    EXPECT_LT(singular.row, 2 * n);
  }
}

TEST(Singular, NotANumberIsReported) {
  Problem problem = testing::grid(3);
  problem.lower.coeffRef(30, 30) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GE(report(problem).row, 0);
}

TEST(Singular, SolverRecoversWithARegularMatrix) {
  const Problem problem = testing::grid(4);
  Problem singular = problem;
  singular.lower.coeffRef(50, 50) = -1;
  SupernodalCholesky solver(problem.lower, problem.node_of, Indices{9, 4});
  EXPECT_THROW(solver.factorize(singular.lower), SingularMatrix);
  solver.factorize(problem.lower);
  const Eigen::VectorXd b = testing::random_vector(solver.size(), 1), x = testing::solve(solver, b);
  EXPECT_LT((problem.dense() * x - b).norm(), 1e-12 * problem.dense().norm() * x.norm());
}

TEST(Arguments, AreChecked) {
  const Problem problem = testing::grid(3);
  EXPECT_THROW(SupernodalCholesky(problem.lower, problem.node_of, Indices{81}), std::invalid_argument);
  EXPECT_THROW(SupernodalCholesky(problem.lower, problem.node_of, Indices{-1}), std::invalid_argument);
  EXPECT_THROW(SupernodalCholesky(problem.lower, problem.node_of, Indices{4, 4}), std::invalid_argument);
  EXPECT_THROW(SupernodalCholesky(problem.lower, Indices{1, 2}, {}), std::invalid_argument);
  EXPECT_THROW(SupernodalCholesky(problem.lower.leftCols(80), problem.node_of, {}), std::invalid_argument);
  SupernodalCholesky solver(problem.lower, problem.node_of, {});
  EXPECT_THROW(solver.factorize(testing::random_sparse(81, 1).lower), std::invalid_argument);
  EXPECT_THROW(solver.factorize(testing::grid(4).lower), std::invalid_argument);
}

}  // namespace
}  // namespace singular_tests
}  // namespace creepcontact::linalg
