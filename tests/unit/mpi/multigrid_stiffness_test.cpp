#include "creepcontact/mpi/multigrid_stiffness.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "creepcontact/base/error.hpp"
#include "creepcontact/mpi/mpi_team.hpp"
#include "unit/mpi/matrix_parts.hpp"

namespace creepcontact::mpi {
namespace {

using linalg::testing::Problem;
using testing::dealt_out;
using testing::part;
using testing::shared_out;

class MultigridStiffness : public ::testing::Test {
 protected:
  Eigen::VectorXd solve(linalg::StiffnessSolver& solver, const Eigen::VectorXd& b,
                        const linalg::SparseMatrix& own) const {
    std::vector<double> y = part(b, own, team), x(y.size());
    solver.forward(y, y);
    solver.backward(y, x);
    return Eigen::VectorXd::Map(x.data(), b.size());
  }
  const MpiTeam team;
};

/// As the iterations that use it need it: symmetric, and within its error bound.
TEST_F(MultigridStiffness, IsALinearInverseWithinItsErrorBound) {
  const Problem problem = linalg::testing::grid(6);
  const Eigen::MatrixXd whole = problem.dense();
  const auto energy = [&](const Eigen::VectorXd& u) { return std::sqrt(u.dot(whole * u)); };
  const Eigen::VectorXd u = linalg::testing::random_vector(whole.rows(), 3),
                        v = linalg::testing::random_vector(whole.rows(), 4);
  for (const auto& split : {shared_out, dealt_out})
    for (const double error : {0.3, 1e-2, 1e-6}) {
      const linalg::SparseMatrix own = split(problem.lower, team);
      const auto solver = multigrid_stiffness(error)({own, problem.node_of, {}});
      EXPECT_GT(solver->factor_bytes(), 0);
      EXPECT_EQ(solver->trailing_size(), 0);
      solver->factorize(own);
      EXPECT_EQ(solver->error_bound(), error);
      EXPECT_GT(solver->rcond(), 0);
      const Eigen::VectorXd of_u = solve(*solver, whole * u, own), of_v = solve(*solver, whole * v, own);
      EXPECT_LE(energy(of_u - u), error * energy(u));
      EXPECT_GE(energy(of_u - u), 1e-4 * error * energy(u)) << "more cycles than asked for";
      EXPECT_NEAR(of_u.dot(whole * v), of_v.dot(whole * u), 1e-10 * energy(u) * energy(v));
      const Eigen::VectorXd of_sum = solve(*solver, whole * (u - 2 * v), own);
      EXPECT_LE((of_sum - of_u + 2 * of_v).norm(), 1e-10 * of_sum.norm());
    }
}

TEST_F(MultigridStiffness, TakesNewValuesNodesOfFewerUnknownsAndNone) {
  // Every fifth unknown is held: nodes keep three, two or one.
  const Problem problem = linalg::testing::grid(4);
  std::vector<Index> kept;
  for (Index i = 0; i < std::ssize(problem.node_of); ++i)
    if (i % 5 != 0 && i % 7 != 0) kept.push_back(i);
  std::vector<std::int64_t> node_of;
  for (const Index i : kept) node_of.push_back(problem.node_of[i]);
  const Eigen::MatrixXd whole = problem.dense()(kept, kept);
  linalg::SparseMatrix own = dealt_out(linalg::testing::lower_of(whole), team);
  const auto motions = [&] {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(std::ssize(kept), 6);  // as of a body that cannot rotate
    for (Index i = 0; i < all.rows(); ++i) all(i, kept[i] % 3) = 1;
    return all;
  };
  const auto solver = multigrid_stiffness(1e-8)({own, node_of, {}, motions});
  const Eigen::VectorXd u = linalg::testing::random_vector(whole.rows(), 5);
  for (const double factor : {1.0, 3.0}) {
    solver->factorize(own);
    EXPECT_LE((solve(*solver, factor * whole * u, own) - u).norm(), 1e-6 * u.norm());
    own.coeffs() *= 3;
  }

  const linalg::SparseMatrix none(0, 0);
  const auto empty = multigrid_stiffness(0.1)({none, {}, {}});
  empty->factorize(none);
  std::vector<double> nothing;
  empty->forward(nothing, nothing);
  empty->backward(nothing, nothing);
}

TEST_F(MultigridStiffness, RefusesSingularMatrices) {
  const Problem problem = linalg::testing::grid(4);
  Eigen::MatrixXd singular = problem.dense();
  singular.row(40) = singular.row(37);
  singular.col(40) = singular.col(37);
  singular(40, 40) = singular(37, 37);
  const linalg::SparseMatrix own = shared_out(linalg::testing::lower_of(singular), team);
  const auto solver = multigrid_stiffness(0.1)({own, problem.node_of, {}});
  EXPECT_THROW(solver->factorize(own), SolverError);
}

}  // namespace
}  // namespace creepcontact::mpi
