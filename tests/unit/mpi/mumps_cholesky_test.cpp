#include "creepcontact/mpi/mumps_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <numeric>

#include "creepcontact/mpi/mpi_team.hpp"
#include "unit/mpi/matrix_parts.hpp"

namespace creepcontact::mpi {
namespace {

using linalg::testing::Problem;
using testing::dealt_out;
using testing::part;
using testing::shared_out;

class MumpsCholesky : public ::testing::Test {
 protected:
  const MpiTeam team;
};

TEST_F(MumpsCholesky, SolvesWhatTheSerialSolverDoes) {
  const Problem problem = linalg::testing::grid(5);
  const Eigen::MatrixXd whole = problem.dense();
  const Eigen::VectorXd b = linalg::testing::random_vector(whole.rows(), 3);
  const Eigen::VectorXd expected = whole.llt().solve(b);
  for (const auto& split : {shared_out, dealt_out})
    for (const std::vector<std::int64_t>& trailing :
         {std::vector<std::int64_t>{}, {7}, {374, 20, 21, 22, 200, 3, 4, 5}}) {
      const linalg::SparseMatrix own = split(problem.lower, team);
      const auto solver = mumps_cholesky({own, problem.node_of, trailing});
      EXPECT_EQ(solver->size(), whole.rows());
      EXPECT_GT(solver->factor_bytes(), 0);
      EXPECT_GE(solver->work_bytes(), 0);
      for (int time = 0; time < 2; ++time) {
        solver->factorize(own);
        EXPECT_GT(solver->rcond(), 1e-9);
        std::vector<double> y = part(b, own, team), x(y.size());
        solver->forward(y, y);
        solver->backward(y, x);
        EXPECT_LE((Eigen::VectorXd::Map(x.data(), b.size()) - expected).norm(), 1e-11 * expected.norm());
      }
    }
}

/// Forces added to the trailing part between the halves, and the trailing factor, are those of a single process.
TEST_F(MumpsCholesky, TrailingPartIsThatOfTheSerialSolver) {
  const Problem problem = linalg::testing::grid(4);
  const std::vector<std::int64_t> trailing{100, 101, 102, 9, 10, 11};
  const auto n_trailing = std::ssize(trailing);
  const Eigen::MatrixXd whole = problem.dense();
  const Eigen::VectorXd b = linalg::testing::random_vector(whole.rows(), 4);
  const auto serial = linalg::default_stiffness_solver({problem.lower, problem.node_of, trailing});
  serial->factorize(problem.lower);
  const linalg::SparseMatrix own = dealt_out(problem.lower, team);
  const auto solver = mumps_cholesky({own, problem.node_of, trailing});
  solver->factorize(own);
  std::vector<double> y = part(b, own, team), expected(y.size()), x(y.size());
  solver->forward(y, y);
  serial->forward({b.data(), y.size()}, expected);
  const Eigen::VectorXd more = linalg::testing::random_vector(n_trailing, 5);
  const auto end_of = [&](std::vector<double>& v) {
    return Eigen::VectorXd::Map(v.data() + v.size() - n_trailing, n_trailing);
  };
  if (team.rank() == 0) {
    EXPECT_LE((end_of(y) - end_of(expected)).norm(), 1e-11 * end_of(expected).norm());
    EXPECT_LE((solver->trailing_factor() - serial->trailing_factor()).norm(), 1e-11 * serial->trailing_factor().norm());
    end_of(y) += more;
  }
  end_of(expected) += more;
  solver->backward(y, x);
  serial->backward(expected, expected);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-10);
  EXPECT_GT(solver->rcond(), 0.01 * serial->rcond());
  EXPECT_LT(solver->rcond(), 100 * serial->rcond());
}

TEST_F(MumpsCholesky, NamesSingularMatricesOnAllProcesses) {
  Problem problem = linalg::testing::grid(3);
  Eigen::MatrixXd dense = problem.dense();
  for (const bool in_trailing : {false, true}) {
    Eigen::MatrixXd singular = dense;
    singular.row(40) = singular.row(37);
    singular.col(40) = singular.col(37);
    singular(40, 40) = singular(37, 37);
    const linalg::SparseMatrix own = shared_out(linalg::testing::lower_of(singular), team);
    const std::vector<std::int64_t> trailing =
        in_trailing ? std::vector<std::int64_t>{37, 40} : std::vector<std::int64_t>{5};
    const auto solver = mumps_cholesky({own, problem.node_of, trailing});
    EXPECT_THROW(solver->factorize(own), linalg::SingularMatrix);
  }
}

TEST_F(MumpsCholesky, TakesNoUnknownsAndNewValues) {
  const linalg::SparseMatrix none(0, 0);
  const auto empty = mumps_cholesky({none, {}, {}});
  empty->factorize(none);
  std::vector<double> nothing;
  empty->forward(nothing, nothing);
  empty->backward(nothing, nothing);

  const Problem problem = linalg::testing::grid(3);
  linalg::SparseMatrix own = shared_out(problem.lower, team);
  const std::vector<std::int64_t> trailing{1, 2};
  const auto solver = mumps_cholesky({own, problem.node_of, trailing});
  solver->factorize(own);
  const auto other = solver->same_pattern();
  own.coeffs() *= 2;
  other->factorize(own);
  const Eigen::VectorXd b = linalg::testing::random_vector(own.rows(), 6);
  std::vector<double> y = part(b, own, team), x(y.size()), half(y.size());
  solver->forward(y, x);
  solver->backward(x, x);
  other->forward(y, half);
  other->backward(half, half);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(half[i], x[i] / 2, 1e-10);
}

}  // namespace
}  // namespace creepcontact::mpi
