/// Factors that are kept are those that would be computed.

#include "creepcontact/linalg/factor_store.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>
#include <utility>
#include <vector>

#include "creepcontact/base/error.hpp"

namespace creepcontact::linalg {
namespace {

/// A chain of springs, with the first node held.
SparseMatrix chain(int n, double stiffness) {
  SparseMatrix lower(n, n);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, i + 1 < n ? 2 * stiffness : stiffness);
    if (i + 1 < n) entries.emplace_back(i + 1, i, -stiffness);
  }
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

constexpr int size = 40;

struct Blocks {
  Blocks() { std::iota(of.begin(), of.end(), 0); }
  std::vector<std::int64_t> of = std::vector<std::int64_t>(size);
  std::vector<std::int64_t> trailing{3, 7};
};

/// The displacement of all nodes by a force at the last one.
std::vector<double> solved(StiffnessSolver& solver, const SparseMatrix& matrix) {
  solver.factorize(matrix);
  std::vector<double> x(size, 0.0);
  x.back() = 1;
  solver.forward(x, x);
  solver.backward(x, x);
  return x;
}

TEST(FactorStore, TheSameMatrixIsFactoredOnce) {
  const Blocks blocks;
  FactorStore store;
  const StiffnessSolverFactory lend = store.lending();
  const SparseMatrix matrix = chain(size, 3.0);
  const std::vector<double> expected = solved(*default_stiffness_solver({matrix, blocks.of, blocks.trailing}), matrix);
  for (int i = 0; i < 3; ++i) {
    const auto solver = lend({matrix, blocks.of, blocks.trailing});
    EXPECT_EQ(solved(*solver, matrix), expected);
    EXPECT_EQ(solver->found_factor(), i > 0);
    EXPECT_EQ(solver->trailing_size(), 2);
  }
  EXPECT_EQ(store.n_computed(), 1);
  EXPECT_EQ(store.n_found(), 2);
}

TEST(FactorStore, AnotherMatrixIsFactored) {
  const Blocks blocks;
  FactorStore store;
  const StiffnessSolverFactory lend = store.lending();
  const SparseMatrix soft = chain(size, 1), hard = chain(size, 2);
  solved(*lend({soft, blocks.of, blocks.trailing}), soft);
  {
    const auto solver = lend({hard, blocks.of, blocks.trailing});
    EXPECT_NEAR(solved(*solver, hard).back(), size / 2.0, 1e-9);
    EXPECT_FALSE(solver->found_factor());
    // The run goes on with another stiffness: what comes back has that one.
    EXPECT_NEAR(solved(*solver, soft).back(), size, 1e-9);
  }
  const auto solver = lend({soft, blocks.of, blocks.trailing});
  EXPECT_NEAR(solved(*solver, soft).back(), size, 1e-9);
  EXPECT_TRUE(solver->found_factor());
  // Other dofs at the end make another factor.
  const std::vector<std::int64_t> other{7, 3};
  const auto turned = lend({soft, blocks.of, other});
  solved(*turned, soft);
  EXPECT_FALSE(turned->found_factor());
}

TEST(FactorStore, AMatrixOfKnownInputsIsNotMade) {
  const Blocks blocks;
  FactorStore store;
  const StiffnessSolverFactory lend = store.lending();
  const SparseMatrix soft = chain(size, 1), hard = chain(size, 2);
  int n_made = 0;
  const auto on_demand = [&](const SparseMatrix& matrix, MatrixInputs inputs) {
    return MatrixOnDemand(
        [&]() -> const SparseMatrix& {
          ++n_made;
          return matrix;
        },
        inputs);
  };
  const auto displacement = [&](const SparseMatrix& matrix, MatrixInputs inputs,
                                std::span<const std::int64_t> trailing) {
    const auto solver = lend({on_demand(matrix, inputs), blocks.of, trailing});
    if (!solver->take_factor()) return solved(*solver, matrix).back();
    EXPECT_TRUE(solver->found_factor());
    std::vector<double> x(size, 0.0);
    x.back() = 1;
    solver->forward(x, x);
    solver->backward(x, x);
    return x.back();
  };
  EXPECT_NEAR(displacement(soft, {1, 1}, blocks.trailing), size, 1e-9);
  EXPECT_GT(std::exchange(n_made, 0), 0);
  EXPECT_NEAR(displacement(soft, {1, 1}, blocks.trailing), size, 1e-9);
  EXPECT_EQ(n_made, 0);
  EXPECT_EQ(store.n_computed(), 1);
  EXPECT_EQ(store.n_found(), 1);
  // Other inputs, or another order.
  EXPECT_NEAR(displacement(hard, {1, 2}, blocks.trailing), size / 2.0, 1e-9);
  EXPECT_GT(std::exchange(n_made, 0), 0);
  const std::vector<std::int64_t> other{7, 3};
  EXPECT_NEAR(displacement(hard, {1, 2}, other), size / 2.0, 1e-9);
  EXPECT_GT(std::exchange(n_made, 0), 0);
  // What was factored is not what was analysed: the inputs stay unknown.
  {
    const auto solver = lend({on_demand(soft, {3, 3}), blocks.of, blocks.trailing});
    EXPECT_NEAR(solved(*solver, hard).back(), size / 2.0, 1e-9);
  }
  n_made = 0;
  EXPECT_NEAR(displacement(soft, {3, 3}, blocks.trailing), size, 1e-9);
  EXPECT_GT(n_made, 0);
}

TEST(FactorStore, ThreadsShareAFactor) {
  const Blocks blocks;
  FactorStore store;
  const SparseMatrix matrix = chain(size, 1);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      const StiffnessSolverFactory lend = store.lending();
      for (int k = 0; k < 10; ++k) {
        const auto solver = lend({matrix, blocks.of, blocks.trailing});
        EXPECT_NEAR(solved(*solver, matrix).back(), size, 1e-9);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(store.n_computed(), 1);
  EXPECT_EQ(store.n_found(), 39);
}

TEST(FactorStore, WhoGoesOnToAnotherMatrixLeavesTheOthersTheirs) {
  const Blocks blocks;
  FactorStore store;
  const StiffnessSolverFactory lend = store.lending();
  const SparseMatrix soft = chain(size, 1), hard = chain(size, 2);
  const auto one = lend({soft, blocks.of, blocks.trailing}), other = lend({soft, blocks.of, blocks.trailing});
  solved(*one, soft);
  solved(*other, soft);
  EXPECT_EQ(one->shared_factor(), other->shared_factor());
  EXPECT_NEAR(solved(*other, hard).back(), size / 2.0, 1e-9);
  EXPECT_NE(one->shared_factor(), other->shared_factor());
  EXPECT_NEAR(solved(*one, soft).back(), size, 1e-9);
  EXPECT_TRUE(one->found_factor());
}

TEST(FactorStore, AfterAFailureNothingIsFound) {
  const Blocks blocks;
  FactorStore store;
  const StiffnessSolverFactory lend = store.lending();
  const SparseMatrix sound = chain(size, 1);
  SparseMatrix singular = sound;
  singular.coeffs().setZero();
  {
    const auto solver = lend({sound, blocks.of, blocks.trailing});
    EXPECT_THROW(solver->factorize(singular), SingularMatrix);
    EXPECT_NEAR(solved(*solver, sound).back(), size, 1e-9);
  }
  {
    const auto solver = lend({sound, blocks.of, blocks.trailing});
    solved(*solver, sound);
    EXPECT_TRUE(solver->found_factor());
    EXPECT_THROW(solver->factorize(singular), SingularMatrix);
  }
  const auto solver = lend({sound, blocks.of, blocks.trailing});
  EXPECT_NEAR(solved(*solver, sound).back(), size, 1e-9);
  EXPECT_FALSE(solver->found_factor());
  // A factory that fails leaves the store as it was.
  const StiffnessSolverFactory broken = store.lending(
      nullptr, [](const StiffnessToAnalyze&) -> std::unique_ptr<StiffnessSolver> { throw SolverError("full"); });
  EXPECT_THROW(broken({chain(size - 1, 1), std::span(blocks.of).first(size - 1), {}}), SolverError);
}

TEST(FactorStore, LentFactorsOutliveIt) {
  const Blocks blocks;
  const SparseMatrix matrix = chain(size, 1);
  std::unique_ptr<StiffnessSolver> solver;
  {
    FactorStore store;
    solver = store.lending()({matrix, blocks.of, blocks.trailing});
  }
  EXPECT_NEAR(solved(*solver, matrix).back(), size, 1e-9);
}

}  // namespace
}  // namespace creepcontact::linalg
