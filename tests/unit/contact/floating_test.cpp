/// Bodies held by contact alone, in the condensed problem.
#include "accelerations.hpp"
#include "creepcontact/base/log.hpp"
#include "problems.hpp"

namespace creepcontact::test {
namespace {

using contact::active_set_solver;
using contact::ContactResult;
using contact::schwarz_solver;
using contact::UnbalancedLoad;

/// Loads that press the last bodies of a chain towards the first, off centre.
Eigen::VectorXd pressing(int n_floating, int rows_per_pair, double eccentricity) {
  Eigen::VectorXd resultant(2 * n_floating);
  for (int k = 0; k < n_floating; ++k) {
    resultant[2 * k] = -1.0 * rows_per_pair;
    resultant[2 * k + 1] = eccentricity * rows_per_pair;
  }
  return resultant;
}

class Floating : public testing::TestWithParam<double> {};

TEST_P(Floating, ChainsPressedTogetherAreInEquilibrium) {
  std::mt19937 generator(21);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 60; ++trial) {
    const int n_pairs = 1 + trial % 3, rows = 3 + trial / 2, n_floating = 1 + trial % n_pairs;
    const ContactProblem problem = chain(n_pairs, rows, GetParam(), generator, n_floating);
    ContactLoad load;
    // Overlaps, gaps as large as the deformation, and gaps a thousand times as large: first contact under a force.
    const double apart = trial % 4 == 3 ? 1000.0 : 0.5;
    load.gap = Eigen::VectorXd::NullaryExpr(problem.n_rows(), [&] { return normal(generator) + apart; });
    load.resultant = pressing(n_floating, rows, std::clamp(0.3 * normal(generator), -0.9, 0.9));
    const ContactResult result = active_set_solver(problem)->solve(load, {});
    expect_solved(problem, load, result.state, 1e-9);

    for (const Acceleration acceleration : accelerations) {
      SCOPED_TRACE(testing::Message() << "acceleration " << static_cast<int>(acceleration) << ", trial " << trial);
      testing::internal::CaptureStderr();
      const ContactResult schwarz = schwarz_solver(problem, accelerated(acceleration))->solve(load, {});
      const std::string warnings = testing::internal::GetCapturedStderr();
      expect_solved(problem, load, schwarz.state, 1e-8);
      if (acceleration == Acceleration::cg) {
        EXPECT_EQ(warnings, "");
      }
      EXPECT_LE(std::count(warnings.begin(), warnings.end(), '\n'), 1) << warnings;
    }

    const ContactResult again = active_set_solver(problem)->solve(load, result.state);
    EXPECT_EQ(again.set_changes, 1) << "a warm start at the solution";
  }
}

INSTANTIATE_TEST_SUITE_P(StiffnessRatios, Floating, testing::Values(1e-3, 1.0, 1e3));

TEST(FloatingBody, WithoutLoadsStaysWhereItIs) {
  std::mt19937 generator(2);
  const ContactProblem problem = chain(1, 5, 1.0, generator, 1);
  const ContactLoad load{Eigen::VectorXd::Ones(5), Eigen::VectorXd::Zero(2)};
  const ContactResult result = active_set_solver(problem)->solve(load, {});
  EXPECT_EQ(result.state.multiplier.norm(), 0);
  EXPECT_EQ(result.state.rigid.norm(), 0);
}

TEST(FloatingBody, PulledOffFliesOffAlongThePull) {
  std::mt19937 generator(2);
  const ContactProblem problem = chain(1, 5, 1.0, generator, 1);
  for (const double gap : {-1.0, 0.0, 1.0}) {
    const ContactLoad load{Eigen::VectorXd::Constant(5, gap), Eigen::Vector2d(3.0, 0.0)};
    try {
      active_set_solver(problem)->solve(load, {});
      ADD_FAILURE() << "no error";
    } catch (const UnbalancedLoad& unbalanced) {
      EXPECT_LT((unbalanced.motion - Eigen::Vector2d(1, 0)).norm(), 1e-9);
    }
  }
}

// The loads of bodies in balance sum to round-off, in whatever unit they are given.
TEST(FloatingBody, WhatIsRoundOffIsJudgedByTheLoads) {
  std::mt19937 generator(2);
  const ContactProblem problem = chain(1, 5, 1.0, generator, 1);
  for (const double unit : {1e-6, 1.0, 1e6})
    for (const double gap : {-1.0, 0.0, 1.0}) {
      // An overlap that no force upholds: the body moves away.
      ContactLoad load{Eigen::VectorXd::Constant(5, gap * unit), unit * Eigen::Vector2d(3e-14, 0.0)};
      load.force = unit * Eigen::Vector2d(400.0, 400.0);
      for (const auto& solver : {active_set_solver(problem), schwarz_solver(problem, {})}) {
        const ContactState state = solver->solve(load, {}).state;
        EXPECT_LT(state.multiplier.cwiseAbs().maxCoeff(), 1e-9 * unit);
        load.resultant *= 1e8;
        EXPECT_THROW(solver->solve(load, {}), UnbalancedLoad) << "a load";
        load.resultant /= 1e8;
      }
    }
}

TEST(FloatingBody, PressedOutsideItsSupportTiltsOff) {
  std::mt19937 generator(2);
  const ContactProblem problem = chain(1, 5, 1.0, generator, 1);
  const ContactLoad inside{Eigen::VectorXd::Zero(5), Eigen::Vector2d(-5.0, 4.9)};
  expect_solved(problem, inside, active_set_solver(problem)->solve(inside, {}).state, 1e-9);
  const ContactLoad outside{Eigen::VectorXd::Zero(5), Eigen::Vector2d(-5.0, 5.1)};
  EXPECT_THROW(active_set_solver(problem)->solve(outside, {}), UnbalancedLoad);
}

TEST(FloatingBody, TiedCarriesAnyLoad) {
  std::mt19937 generator(2);
  ContactProblem problem = chain(1, 5, 1.0, generator, 1);
  for (contact::ContactNode& node : problem.nodes) node.set = contact::AdmissibleSet::space;
  const ContactLoad load{Eigen::VectorXd::Zero(5), Eigen::Vector2d(3.0, 70.0)};
  expect_solved(problem, load, active_set_solver(problem)->solve(load, {}).state, 1e-9);
}

// Two contacts cannot hold a body against a force between them in a third direction; the motion keeps amplitude 0.
TEST(FloatingBody, MotionThatNoContactOpensKeepsItsPlace) {
  std::mt19937 generator(4);
  ContactProblem problem = chain(1, 5, 1.0, generator, 1);
  problem.rigid.col(1).setZero();
  problem.rigid_of_body[1].col(1).setZero();
  const ContactLoad load{Eigen::VectorXd::Zero(5), Eigen::Vector2d(-3.0, 0.0)};
  const ContactState state = active_set_solver(problem)->solve(load, {}).state;
  expect_solved(problem, load, state, 1e-9);
  EXPECT_EQ(state.rigid[1], 0);
}

}  // namespace
}  // namespace creepcontact::test
