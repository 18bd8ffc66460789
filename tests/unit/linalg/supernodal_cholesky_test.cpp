#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <atomic>
#include <numeric>
#include <optional>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "matrices.hpp"

namespace creepcontact::linalg {
namespace {

using testing::Problem;
using Indices = std::vector<std::int64_t>;

Indices shuffled(Indices indices, unsigned seed) {
  std::mt19937 random(seed);
  std::shuffle(indices.begin(), indices.end(), random);
  return indices;
}

Indices all_of(const Problem& problem) {
  Indices indices(problem.lower.rows());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/// `count` unknowns anywhere, in any order.
Indices some_of(const Problem& problem, std::size_t count, unsigned seed) {
  Indices indices = shuffled(all_of(problem), seed);
  indices.resize(count);
  return indices;
}

/// Solution, trailing block and the meaning of the split solve, against dense algebra.
void check(const Problem& problem, const Indices& trailing) {
  SupernodalCholesky solver(problem.lower, problem.node_of, trailing);
  solver.factorize(problem.lower);
  ASSERT_EQ(solver.size(), problem.lower.rows());
  ASSERT_EQ(solver.trailing_size(), std::ssize(trailing));
  EXPECT_GT(solver.rcond(), 1e-8);

  const Eigen::MatrixXd dense = problem.dense();
  const Eigen::VectorXd b = testing::random_vector(dense.rows(), 5);
  const Eigen::VectorXd x = testing::solve(solver, b);
  EXPECT_LT((dense * x - b).norm(), 1e-12 * (dense.norm() * x.norm() + b.norm()));
  EXPECT_LT((x - dense.llt().solve(b)).norm(), 1e-11 * x.norm());

  const Eigen::MatrixXd l22 = solver.trailing_factor();
  ASSERT_EQ(l22.rows(), std::ssize(trailing));
  ASSERT_EQ(l22.cols(), std::ssize(trailing));
  if (trailing.empty()) return;
  EXPECT_TRUE(l22.isLowerTriangular(0));
  EXPECT_GT(l22.diagonal().minCoeff(), 0);
  const Eigen::MatrixXd schur = testing::schur_complement(dense, trailing);
  EXPECT_LT((l22 * l22.transpose() - schur).norm(), 1e-12 * schur.norm());

  // The trailing part of the forward pass, y2 = L22^T x2 with x2 in the caller's order: what condensation rests on.
  const Eigen::VectorXd y2 = testing::forward(solver, b).tail(std::ssize(trailing));
  const Eigen::VectorXd x2 = x(trailing);
  EXPECT_LT((y2 - l22.transpose() * x2).norm(), 1e-11 * y2.norm());
}

TEST(SupernodalCholesky, WithoutTrailingUnknowns) {
  check(testing::random_sparse(150, 1), {});
  check(testing::grid(6), {});
}

TEST(SupernodalCholesky, WithTrailingUnknownsInAnyOrder) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Problem problem = testing::random_sparse(150, seed);
    for (const std::size_t count : {1u, 2u, 17u, 80u}) check(problem, some_of(problem, count, seed));
  }
}

TEST(SupernodalCholesky, WithAFaceOfAGridTrailing) {
  const Problem problem = testing::grid(6);
  const Indices unknowns = all_of(problem);
  const Indices face(unknowns.end() - 3 * 36, unknowns.end());
  check(problem, face);
  check(problem, shuffled(face, 3));
  check(problem, some_of(problem, 200, 4));
}

TEST(SupernodalCholesky, WithPartOfTheUnknownsOfANodeTrailing) {
  const Problem problem = testing::grid(4);
  check(problem, {0, 5, 10, 100, 77});
}

TEST(SupernodalCholesky, WithAllUnknownsTrailing) {
  const Problem problem = testing::random_sparse(60, 2);
  check(problem, shuffled(all_of(problem), 2));
  const Problem body = testing::grid(3, 2);
  check(body, shuffled(all_of(body), 2));
}

TEST(SupernodalCholesky, WithBodiesThatAreNotConnected) {
  const Problem problem = testing::grid(4, 3);
  check(problem, {});
  check(problem, some_of(problem, 40, 1));  // in all of them, mixed
  Indices one_body(20);
  std::iota(one_body.begin(), one_body.end(), 200);
  check(problem, one_body);
}

TEST(SupernodalCholesky, WithPartsConnectedByTrailingUnknownsAlone) {
  Eigen::MatrixXd dense = 4 * Eigen::MatrixXd::Identity(9, 9);
  for (const Index neighbour : {0, 1, 2, 3}) dense(8, neighbour) = dense(neighbour, 8) = 0.5;
  for (const Index neighbour : {4, 5, 6}) dense(7, neighbour) = dense(neighbour, 7) = -0.5;
  Problem problem{testing::lower_of(dense), {}};
  problem.node_of = all_of(problem);
  check(problem, {7, 8});
  check(problem, {8, 7});
  check(problem, {8, 3, 7});
}

TEST(SupernodalCholesky, WithAPartThatHangsAtALaterTrailingUnknown) {
  // Unknown 0 touches 2 and not 1; postordered by weight, either of 0 and 1 may come first.
  for (const auto& [light, heavy] : {std::pair{0, 1}, std::pair{1, 0}}) {
    Eigen::MatrixXd dense = 3 * Eigen::MatrixXd::Identity(5, 5);
    for (const Index neighbour : {2, 3, 4}) dense(heavy, neighbour) = dense(neighbour, heavy) = 0.5;
    dense(light, 2) = dense(2, light) = 0.5;
    Problem problem{testing::lower_of(dense), {}};
    problem.node_of = all_of(problem);
    check(problem, {1, 2, 3, 4});
    check(problem, {2, 1, 4, 3});
  }
}

TEST(SupernodalCholesky, OfADiagonalMatrixAndOfOneUnknown) {
  Problem problem{testing::lower_of(Eigen::VectorXd::LinSpaced(12, 1, 4).asDiagonal().toDenseMatrix()), {}};
  problem.node_of = all_of(problem);
  check(problem, {});
  check(problem, {7, 2, 9});
  check({testing::lower_of(Eigen::MatrixXd::Constant(1, 1, 3)), {0}}, {0});
}

TEST(SupernodalCholesky, SolvesInPlace) {
  const Problem problem = testing::grid(4);
  SupernodalCholesky solver(problem.lower, problem.node_of, Indices{3, 1});
  solver.factorize(problem.lower);
  const Eigen::VectorXd b = testing::random_vector(solver.size(), 1);
  Eigen::VectorXd x = b;
  const std::span whole(x.data(), x.size());
  solver.forward(whole, whole);
  solver.backward(whole, whole);
  EXPECT_EQ(x, testing::solve(solver, b));
}

TEST(SupernodalCholesky, FactorizesAgainWithOtherValues) {
  Problem problem = testing::grid(5);
  SupernodalCholesky solver(problem.lower, problem.node_of, Indices{40, 4, 14});
  const std::int64_t bytes = solver.factor_bytes();
  EXPECT_GE(bytes, problem.lower.nonZeros() * 8);
  solver.factorize(problem.lower);
  const Eigen::VectorXd b = testing::random_vector(solver.size(), 1), x = testing::solve(solver, b);
  problem.lower *= 2.0;
  solver.factorize(problem.lower);
  EXPECT_LT((testing::solve(solver, b) - 0.5 * x).norm(), 1e-14 * x.norm());
  EXPECT_EQ(solver.factor_bytes(), bytes);
}

TEST(SupernodalCholesky, GivesASecondSolverWithoutAnalysis) {
  Problem problem = testing::grid(5);
  const Indices trailing{40, 4, 14};
  std::optional<SupernodalCholesky> first(std::in_place, problem.lower, problem.node_of, trailing);
  const auto second = first->same_pattern();  // of an analysis ...
  first->factorize(problem.lower);
  const auto third = first->same_pattern();  // ... and of a factor
  const Eigen::VectorXd b = testing::random_vector(first->size(), 1), x = testing::solve(*first, b);
  const Eigen::MatrixXd l22 = first->trailing_factor();
  problem.lower *= 2.0;
  second->factorize(problem.lower);
  problem.lower *= 2.0;
  third->factorize(problem.lower);
  EXPECT_EQ(testing::solve(*first, b), x) << "the first one stays as it is";
  first.reset();
  EXPECT_LT((testing::solve(*second, b) - 0.5 * x).norm(), 1e-14 * x.norm());
  EXPECT_LT((testing::solve(*third, b) - 0.25 * x).norm(), 1e-14 * x.norm());
  EXPECT_LT((third->trailing_factor() - 2.0 * l22).norm(), 1e-13 * l22.norm());
  EXPECT_EQ(third->trailing_size(), std::ssize(trailing));
}

TEST(SupernodalCholesky, Moves) {
  const Problem problem = testing::grid(4);
  const Eigen::VectorXd b = testing::random_vector(problem.lower.rows(), 1);
  SupernodalCholesky first(problem.lower, problem.node_of, Indices{7, 3});
  first.factorize(problem.lower);
  const Eigen::VectorXd x = testing::solve(first, b);
  SupernodalCholesky second(std::move(first));
  EXPECT_EQ(testing::solve(second, b), x);
  SupernodalCholesky third(problem.lower, problem.node_of, {});
  third = std::move(second);
  EXPECT_EQ(testing::solve(third, b), x);
  second = SupernodalCholesky(problem.lower, problem.node_of, {});  // a moved-from object takes a new value
  second.factorize(problem.lower);
  EXPECT_LT((testing::solve(second, b) - x).norm(), 1e-11 * x.norm());
}

TEST(SupernodalCholesky, HasTheSameBitsWhateverOtherThreadsDo) {
  const Problem problem = testing::grid(8);
  const Eigen::VectorXd b = testing::random_vector(problem.lower.rows(), 1);
  const auto solved = [&] {
    SupernodalCholesky solver(problem.lower, problem.node_of, Indices{7, 3});
    solver.factorize(problem.lower);
    return testing::solve(solver, b);
  };
  const Eigen::VectorXd alone = solved();
  std::atomic<int> different = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 10; ++k) different += solved() != alone;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace creepcontact::linalg
