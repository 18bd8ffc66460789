/// Passes that several threads make together are those of each alone.

#include "creepcontact/linalg/gathered_passes.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "creepcontact/linalg/factor_store.hpp"
#include "matrices.hpp"

namespace creepcontact::linalg {
namespace {

using testing::Problem;

std::vector<double> vector_of(const Eigen::VectorXd& x) {
  return {x.begin(), x.end()};
}

/// A sequence of solutions, each with the one before as its right-hand side: x = K^-1 x, `n` times.
std::vector<double> iterated(StiffnessSolver& solver, std::vector<double> x, int n) {
  for (int i = 0; i < n; ++i) {
    solver.forward(x, x);
    solver.backward(x, x);
    double norm = 0;
    for (const double value : x) norm = std::max(norm, std::abs(value));
    for (double& value : x) value /= norm;
  }
  return x;
}

class Gathering : public ::testing::Test {
 protected:
  std::unique_ptr<StiffnessSolver> solver(const SparseMatrix& matrix) {
    auto made = store_.lending(&passes_)({matrix, problem_.node_of, {}});
    made->factorize(matrix);
    return made;
  }
  /// Job j makes j + 3 solutions. @param stiffer  the matrix of odd jobs, relative to that of the even ones
  std::vector<std::vector<double>> run(std::size_t n_jobs, std::size_t at_once, double stiffer) {
    std::vector<std::vector<double>> results(n_jobs);
    std::vector<std::function<void()>> jobs;
    for (std::size_t j = 0; j < n_jobs; ++j)
      jobs.emplace_back([&, j] {
        const SparseMatrix matrix = (j % 2 == 1 ? stiffer : 1.0) * problem_.lower;
        results[j] = iterated(*solver(matrix), vector_of(start(j)), static_cast<int>(j) + 3);
      });
    passes_.run(jobs, at_once);
    return results;
  }
  Eigen::VectorXd start(std::size_t j) const {
    return testing::random_vector(problem_.lower.rows(), static_cast<int>(j) + 1);
  }

  Problem problem_ = testing::grid(12);
  FactorStore store_;
  GatheredPasses passes_;
};

TEST_F(Gathering, EachHasItsOwnSolutions) {
  constexpr std::size_t n_jobs = 11;
  const auto results = run(n_jobs, 4, 1);
  const auto alone = solver(problem_.lower);
  std::int64_t n = 0;
  for (std::size_t j = 0; j < n_jobs; ++j) {
    const auto expected = iterated(*alone, vector_of(start(j)), static_cast<int>(j) + 3);
    for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(results[j][i], expected[i], 1e-12) << "job " << j;
    n += static_cast<std::int64_t>(j) + 3;
  }
  EXPECT_EQ(store_.n_computed(), 1);
  EXPECT_EQ(passes_.counters().vectors, 2 * n);
  // Four at a time but for the last ones, which are left alone.
  EXPECT_LT(passes_.counters().passes, n);
}

TEST_F(Gathering, WhatComesTogetherDoesNotDependOnTheThreads) {
  const auto first = run(9, 4, 2.5);
  const std::int64_t passes = passes_.counters().passes;
  for (int repeat = 1; repeat < 10; ++repeat) {
    ASSERT_EQ(run(9, 4, 2.5), first);
    ASSERT_EQ(passes_.counters().passes, passes * (repeat + 1));
  }
}

TEST_F(Gathering, AJobThatFailsDoesNotHoldUpTheOthers) {
  std::vector<double> result;
  std::vector<std::function<void()>> jobs{[&] {
                                            const auto mine = solver(problem_.lower);
                                            iterated(*mine, vector_of(start(0)), 2);
                                            throw std::runtime_error("the second");
                                          },
                                          [&] { result = iterated(*solver(problem_.lower), vector_of(start(1)), 9); },
                                          [] { throw std::runtime_error("the third"); }};
  std::swap(jobs[0], jobs[1]);
  try {
    passes_.run(jobs, 3);
    ADD_FAILURE() << "nothing is thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the second");
  }
  EXPECT_EQ(result.size(), static_cast<std::size_t>(problem_.lower.rows()));
  passes_.run({}, 3);
}

TEST_F(Gathering, OtherThreadsMakeTheirPassesThemselves) {
  const auto outside = solver(problem_.lower);
  EXPECT_EQ(iterated(*outside, vector_of(start(3)), 2).size(), static_cast<std::size_t>(problem_.lower.rows()));
  EXPECT_EQ(passes_.counters().passes, 0);
}

}  // namespace
}  // namespace creepcontact::linalg
