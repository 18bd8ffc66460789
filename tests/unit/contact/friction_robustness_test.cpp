/// Friction where Newton's method needs more than its usual start: long rows of nodes that slip one after the other,
/// bodies held by contact alone, limits that depend strongly on the shear tractions.
#include <gtest/gtest.h>

#include "creepcontact/base/error.hpp"
#include "problems.hpp"

namespace creepcontact::contact {
namespace {

using creepcontact::test::expect_friction_solved;
using creepcontact::test::frictional;

/// A bar on a rigid foundation under uniform pressure: the tangential rows are coupled over the whole length, as a
/// force at one place moves all that lies beyond it.
ContactProblem bar(int n) {
  ContactProblem problem;
  for (int i = 0; i < n; ++i) problem.add_node(AdmissibleSet::cone, 2, 0, 1);
  problem.total.setZero(Index{2} * n, Index{2} * n);
  for (int i = 0; i < n; ++i) {
    problem.total(2 * i, 2 * i) = 1e-2;
    for (int j = 0; j < n; ++j) problem.total(2 * i + 1, 2 * j + 1) = 1.0 * (std::min(i, j) + 1) / n;
  }
  Flexibility body;
  for (int r = 0; r < 2 * n; ++r) body.rows.push_back(r);
  body.matrix = problem.total;
  problem.bodies = {body, body};
  for (Flexibility& half : problem.bodies) half.matrix *= 0.5;
  problem.rigid.setZero(Index{2} * n, 0);
  problem.rigid_of_body.assign(2, problem.rigid);
  return problem;
}

/// Pulled at its far end; with the slip of the last state.
ContactLoad pulled(int n, double pressure, double force, const Eigen::VectorXd& slip) {
  ContactLoad load{Eigen::VectorXd::Zero(Index{2} * n), {}, {}};
  for (int i = 0; i < n; ++i) {
    load.gap[2 * i] = -pressure * 1e-2;
    load.gap[2 * i + 1] = force * (i + 1) / n - slip[2 * i + 1];
  }
  load.friction.coefficient.setConstant(n, 0.1);
  return load;
}

TEST(FrictionalBar, ASlipFrontThatPassesManyNodesTakesFewIterations) {
  constexpr int n = 200;
  constexpr double pressure = 1.0, full = 0.1 * pressure * n;  // what friction holds at most
  const ContactProblem problem = bar(n);
  for (const settings::FrictionMethod method : {settings::FrictionMethod::newton, settings::FrictionMethod::tresca}) {
    const auto solver = friction_solver(problem, {method, {}});
    ContactState state;
    Eigen::VectorXd slip = Eigen::VectorXd::Zero(Index{2} * n);
    // Pulled, let go and pushed, in long and short steps.
    for (const double part : {0.9, 0.5, 0.45, -0.3, -0.9, 0.0, 0.9, 0.95}) {
      const ContactLoad load = pulled(n, pressure, part * full, slip);
      const ContactResult result = solver->solve(load, state);
      expect_friction_solved(problem, load, result.state, 1e-9);
      if (method == settings::FrictionMethod::newton) {
        EXPECT_LE(result.iterations, 60) << part;
      }
      for (int i = 0; i < n; ++i) slip[2 * i + 1] += result.gap[2 * i + 1];
      state = result.state;
    }
  }
}

class CoupledFriction : public testing::TestWithParam<std::tuple<bool, double>> {};

// With any coefficient there is a state: with given limits the multipliers depend continuously on the limits and are
// bounded, and the limits are continuous in the multipliers (Brouwer).
TEST_P(CoupledFriction, EveryRandomProblemIsSolved) {
  const auto [floating, mu] = GetParam();
  std::mt19937 generator(17);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 100; ++trial) {
    const ContactProblem problem = frictional(3 + trial % 12, 2, 0.9, generator, floating);
    ContactLoad load{Eigen::VectorXd::NullaryExpr(problem.n_rows(), [&] { return normal(generator); }), {}, {}};
    for (const ContactNode& node : problem.nodes) load.gap[node.first_row] -= 1;
    load.friction.coefficient.setConstant(std::ssize(problem.nodes), mu);
    // Held far below what friction holds.
    if (floating)
      load.resultant =
          std::ssize(problem.nodes) * Eigen::Vector3d(-3, 0.3 * mu * normal(generator), 0.3 * mu * normal(generator));
    SCOPED_TRACE(testing::Message() << "trial " << trial);
    try {
      expect_friction_solved(problem, load, friction_solver(problem, {})->solve(load, {}).state, 1e-8);
    } catch (const SolverError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Coefficients, CoupledFriction,
                         testing::Combine(testing::Bool(), testing::Values(0.15, 0.4, 0.8)));

}  // namespace
}  // namespace creepcontact::contact
