#include <gtest/gtest.h>

#include "accelerations.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/contact/solver/active_set_system.hpp"
#include "problems.hpp"

namespace creepcontact::contact {
namespace {

using creepcontact::test::accelerated;
using creepcontact::test::accelerations;
using creepcontact::test::add_gaskets;
using creepcontact::test::chain;
using creepcontact::test::expect_friction_solved;
using creepcontact::test::expect_solved;
using creepcontact::test::frictional;

Eigen::VectorXd random_gaps(Index n, std::mt19937& generator, double mean) {
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(generator) + mean; });
}

/// A given gasket between two bodies of the same flexibility at one node.
struct OneNode {
  explicit OneNode(std::vector<Eigen::Vector2d> points, double flexibility = 0.5) {
    for (int b = 0; b < 2; ++b) problem.bodies.push_back({{0}, Eigen::MatrixXd::Constant(1, 1, flexibility)});
    problem.total = Eigen::MatrixXd::Constant(1, 1, 2 * flexibility);
    problem.add_node(AdmissibleSet::half_line, 1, 0, 1);
    problem.nodes[0].gasket_area = 2;
    load.curves = {ClosureCurve(std::move(points))};
  }
  ContactProblem problem;
  ContactLoad load;
};

TEST(ClosureCurve, IsZeroAtFirstAndGoesOnBeyondItsLastPoint) {
  const ClosureCurve curve({{0.1, 0}, {0.3, 4}, {0.4, 10}});
  EXPECT_EQ(curve.pressure(-1), 0);
  EXPECT_EQ(curve.pressure(0.1), 0);
  EXPECT_NEAR(curve.pressure(0.2), 2, 1e-14);
  EXPECT_NEAR(curve.pressure(0.3), 4, 1e-14);
  EXPECT_NEAR(curve.pressure(0.5), 16, 1e-13);
  EXPECT_NEAR(curve.line(0.3).slope, 20, 1e-12) << "the piece that ends there";
  EXPECT_NEAR(curve.line(0).slope, 20, 1e-12);
  EXPECT_NEAR(curve.line(0.35).zero, 0.3 - 4 / 60.0, 1e-14);
}

// gap = -3 + lambda, closure = -gap/2, pressure 10 closure beyond 1: lambda = 10 ((3 - lambda)/2 - 1) = 5/6.
TEST(GasketSolver, BalancesOneNode) {
  OneNode one({{1, 0}, {2, 10}});
  one.load.gap = Eigen::VectorXd::Constant(1, -3.0);
  const ContactResult found =
      gasket_solver(one.problem, [](const ContactProblem& of) { return active_set_solver(of); })->solve(one.load, {});
  EXPECT_NEAR(found.state.multiplier[0], 5.0 / 6, 1e-12);
  EXPECT_NEAR(found.state.closure[0], 1 + 1.0 / 12, 1e-12);
  EXPECT_NEAR(found.state.compliance[0], 0.2, 1e-12);
  EXPECT_NEAR(found.gap[0], -2 * (1 + 1.0 / 12), 1e-12);
}

class Gaskets : public testing::TestWithParam<double> {};

TEST_P(Gaskets, AreOnTheirCurvesWithEveryMethod) {
  log::set_level(log::Level::error);
  std::mt19937 generator(3);
  for (int trial = 0; trial < 20; ++trial) {
    const bool floats = trial % 4 == 3;
    ContactProblem problem = chain(1 + trial % 3, 4 + trial, 1.0, generator, floats ? 1 : 0);
    ContactLoad load = add_gaskets(problem, generator, GetParam(), trial % 2 == 0 ? 1.0 : 0.5);
    load.gap = random_gaps(problem.n_rows(), generator, -1);
    if (floats) load.resultant = Eigen::Vector2d(-3, 0.2);  // towards the other body
    const ContactSolverFactory direct = [](const ContactProblem& of) { return active_set_solver(of); };
    const ContactState reference = gasket_solver(problem, direct)->solve(load, {}).state;
    expect_solved(problem, load, reference, 1e-9);
    for (const auto acceleration : accelerations) {
      const auto solver = gasket_solver(
          problem, [&](const ContactProblem& of) { return schwarz_solver(of, accelerated(acceleration)); });
      const ContactState found = solver->solve(load, {}).state;
      EXPECT_LT((found.multiplier - reference.multiplier).cwiseAbs().maxCoeff(),
                1e-6 * reference.multiplier.cwiseAbs().maxCoeff())
          << "acceleration " << static_cast<int>(acceleration) << ", trial " << trial;
    }
  }
  log::set_level(log::Level::info);
}

TEST_P(Gaskets, AreOnTheirCurvesWithFriction) {
  std::mt19937 generator(17);
  for (int trial = 0; trial < 20; ++trial) {
    ContactProblem problem = frictional(3 + trial, 1 + trial % 2, 0.3, generator, trial % 4 == 3);
    ContactLoad load = add_gaskets(problem, generator, GetParam(), trial % 3 == 0 ? 0.5 : 1.0);
    load.gap = 0.3 * random_gaps(problem.n_rows(), generator, 0);
    for (const ContactNode& node : problem.nodes) load.gap[node.first_row] -= 1;
    load.friction.coefficient = Eigen::VectorXd::Constant(std::ssize(problem.nodes), 0.3);
    if (problem.n_motions() > 0) {
      load.resultant.setZero(problem.n_motions());
      load.resultant[0] = -2;
    }
    const auto solver = gasket_solver(problem, [](const ContactProblem& of) { return friction_solver(of, {}); });
    const ContactState found = solver->solve(load, {}).state;
    expect_friction_solved(problem, load, found, 1e-8);
    EXPECT_LT((found.image - flexibility_product(problem, found.multiplier)).cwiseAbs().maxCoeff(),
              1e-10 * found.image.cwiseAbs().maxCoeff())
        << "F without the compliance of gaskets";
  }
}

INSTANTIATE_TEST_SUITE_P(Stiffness, Gaskets, testing::Values(0.1, 3.0, 100.0));

// From the state itself one iteration suffices, and the result is the same to the last bit.
TEST(GasketSolver, DependsOnItsArgumentsOnly) {
  std::mt19937 generator(9);
  ContactProblem problem = chain(2, 12, 3.0, generator);
  ContactLoad load = add_gaskets(problem, generator, 3, 1);
  load.gap = random_gaps(problem.n_rows(), generator, -1);
  const ContactSolverFactory direct = [](const ContactProblem& of) { return active_set_solver(of); };
  const auto solver = gasket_solver(problem, direct);
  const ContactResult first = solver->solve(load, {});
  const ContactResult again = solver->solve(load, first.state);
  EXPECT_EQ(again.set_changes, 1);
  ContactLoad other = load;
  other.gap.array() -= 2;
  const ContactResult far = solver->solve(other, first.state);
  EXPECT_EQ(far.state.multiplier, gasket_solver(problem, direct)->solve(other, first.state).state.multiplier);
  EXPECT_EQ(solver->solve(load, first.state).state.multiplier, again.state.multiplier);
}

// The derivative of the multipliers with respect to the gaps, by differences.
TEST(GasketSolver, ChangesAsTheLinearisedSystemSays) {
  std::mt19937 generator(21);
  ContactProblem problem = chain(1, 15, 1.0, generator);
  ContactLoad load = add_gaskets(problem, generator, 3, 0.6);
  load.gap = random_gaps(problem.n_rows(), generator, -1);
  const auto solver = gasket_solver(problem, [](const ContactProblem& of) { return active_set_solver(of); });
  const ContactState at = solver->solve(load, {}).state;
  const Eigen::VectorXd direction = random_gaps(problem.n_rows(), generator, 0);
  const double step = 1e-6;
  ContactLoad moved = load;
  moved.gap += step * direction;
  const Eigen::VectorXd difference = (solver->solve(moved, at).state.multiplier - at.multiplier) / step;
  ActiveSetSystem system(problem);
  const Eigen::VectorXd change = system.solve_change(at, direction).multiplier;
  EXPECT_LT((change - difference).cwiseAbs().maxCoeff(), 1e-5 * difference.cwiseAbs().maxCoeff());
}

// A rigid punch, 40 x 10, on a layer of 500 MPa/mm under 2e4 N: 2P/(3 b (L/2 - e)) at the edge for an eccentricity of
// 10, half of the layer open.
TEST(GasketSolver, CarriesARigidPunch) {
  constexpr int n = 400;
  ContactProblem problem;
  problem.bodies = {{{}, Eigen::MatrixXd::Zero(n, n)}, {{}, Eigen::MatrixXd::Zero(n, n)}};
  problem.total.setZero(n, n);
  problem.rigid.resize(n, 2);
  ContactLoad load;
  for (int i = 0; i < n; ++i) {
    problem.add_node(AdmissibleSet::half_line, 1, 0, 1);
    problem.nodes.back().gasket_area = 400.0 / n;
    load.curves.emplace_back(std::vector<Eigen::Vector2d>{{0, 0}, {1, 500}});
    const double x = -20 + 40.0 * (i + 0.5) / n;
    problem.rigid.row(i) << 400.0 / n, x * 400.0 / n;
    for (Flexibility& body : problem.bodies) body.rows.push_back(i);
  }
  problem.rigid_of_body = {Eigen::MatrixXd::Zero(n, 2), problem.rigid};
  load.gap.setZero(n);
  const auto largest = [&](double eccentricity) {
    load.resultant = -2e4 * Eigen::Vector2d(1, eccentricity);
    const auto solver = gasket_solver(problem, [](const ContactProblem& of) { return active_set_solver(of); });
    return solver->solve(load, {}).state.multiplier.maxCoeff();
  };
  EXPECT_NEAR(largest(3), 72.5, 72.5 * 2.0 / n);
  EXPECT_NEAR(largest(10), 133.3333, 133.3333 * 3.0 / n);
}

}  // namespace
}  // namespace creepcontact::contact
