#include <gtest/gtest.h>

#include "accelerations.hpp"
#include "creepcontact/base/log.hpp"
#include "problems.hpp"

namespace creepcontact::contact {
namespace {

using creepcontact::test::expect_friction_solved;
using creepcontact::test::frictional;

Eigen::VectorXd random_vector(Index n, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(generator); });
}

/// Overlaps on average, shears in all directions.
ContactLoad random_load(const ContactProblem& problem, double mu, std::mt19937& generator) {
  ContactLoad load{random_vector(problem.n_rows(), generator), {}, {}};
  for (const ContactNode& node : problem.nodes) load.gap[node.first_row] -= 1;
  load.friction.coefficient.setConstant(std::ssize(problem.nodes), mu);
  return load;
}

class RandomFriction : public testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(RandomFriction, FulfilsTheConditionsOfCoulombsLaw) {
  const auto [n_tangents, mu] = GetParam();
  std::mt19937 generator(3);
  int slipping = 0, sticking = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const ContactProblem problem = frictional(3 + 2 * trial, n_tangents, 0.2, generator);
    const ContactLoad load = random_load(problem, mu, generator);
    const ContactState state = friction_solver(problem, {})->solve(load, {}).state;
    expect_friction_solved(problem, load, state, 1e-9);
    for (const NodeLinearization& node : state.nodes) {
      slipping += node.status == ContactStatus::slip ? 1 : 0;
      sticking += node.status == ContactStatus::stick ? 1 : 0;
    }
  }
  EXPECT_GT(slipping, 20);
  EXPECT_GT(sticking, 10);
}

INSTANTIATE_TEST_SUITE_P(Coefficients, RandomFriction,
                         testing::Combine(testing::Values(1, 2), testing::Values(0.1, 0.3, 0.6)));

TEST(Friction, SlipFollowsTheMeanDirection) {
  std::mt19937 generator(8);
  for (int trial = 0; trial < 10; ++trial) {
    const ContactProblem problem = frictional(20, 2, 0.2, generator);
    ContactLoad load = random_load(problem, 0.2, generator);
    const auto solver = friction_solver(problem, {});
    const ContactState first = solver->solve(load, {}).state;
    load.friction.direction.setZero(problem.n_rows());
    for (std::size_t i = 0; i < problem.nodes.size(); ++i)
      if (first.nodes[i].status == ContactStatus::slip)
        load.friction.direction.segment<2>(problem.nodes[i].first_row + 1) = first.nodes[i].direction;
    load.gap += 0.3 * random_vector(load.gap.size(), generator);
    const ContactState second = solver->solve(load, first).state;
    expect_friction_solved(problem, load, second, 1e-9);
    load.friction.direction.setZero();
    const ContactState backward = solver->solve(load, first).state;
    EXPECT_GT((second.multiplier - backward.multiplier).norm(), 1e-4);
  }
}

TEST(Friction, HoldsABodyUpToMuTimesTheForceThatPressesIt) {
  std::mt19937 generator(4);
  const double mu = 0.3;
  for (const int n_tangents : {1, 2}) {
    const ContactProblem problem = frictional(12, n_tangents, 0.2, generator, true);
    ContactLoad load = random_load(problem, mu, generator);
    load.resultant = Eigen::VectorXd::Zero(1 + n_tangents);
    load.resultant[0] = -50;
    load.resultant[1] = 0.999 * mu * 50;
    const auto solver = friction_solver(problem, {});
    const ContactState held = solver->solve(load, {}).state;
    expect_friction_solved(problem, load, held, 1e-9);
    load.resultant[1] = 1.001 * mu * 50;
    try {
      solver->solve(load, held);
      ADD_FAILURE() << "slides";
    } catch (const UnbalancedLoad& unbalanced) {
      EXPECT_NEAR(unbalanced.force, 0.001 * mu * 50, 1e-4 * mu * 50);
      EXPECT_NEAR(unbalanced.motion[1], 1, 1e-6);
      EXPECT_NEAR(unbalanced.motion[0], 0, 1e-4);
    }
  }
}

class FrozenTractions : public testing::TestWithParam<SchwarzOptions::Acceleration> {};

// Sweeps exchange shear tractions too.
TEST_P(FrozenTractions, AgreeWithNewton) {
  log::set_level(log::Level::error);
  std::mt19937 generator(12);
  for (int trial = 0; trial < 24; ++trial) {
    const int n_tangents = 1 + trial % 2;
    const bool floating = trial % 3 == 0;
    const ContactProblem problem = frictional(4 + trial, n_tangents, 0.2, generator, floating);
    ContactLoad load = random_load(problem, 0.3, generator);
    if (floating) {
      load.resultant = Eigen::VectorXd::Zero(1 + n_tangents);
      load.resultant[0] = -3.0 * trial - 10;
      load.resultant[1] = 0.5 * 0.3 * (3.0 * trial + 10);
    }
    const ContactState newton = friction_solver(problem, {})->solve(load, {}).state;
    const FrictionOptions options{settings::FrictionMethod::tresca, creepcontact::test::accelerated(GetParam())};
    const auto solver = friction_solver(problem, options);
    const ContactState frozen = solver->solve(load, {}).state;
    EXPECT_LT((frozen.multiplier - newton.multiplier).cwiseAbs().maxCoeff(), 1e-7 * newton.multiplier.maxCoeff())
        << "trial " << trial;
    expect_friction_solved(problem, load, frozen, 1e-7);
    EXPECT_EQ(frozen.active, newton.active);
  }
  log::set_level(log::Level::info);
}

INSTANTIATE_TEST_SUITE_P(Accelerations, FrozenTractions,
                         testing::Values(SchwarzOptions::Acceleration::none, SchwarzOptions::Acceleration::anderson,
                                         SchwarzOptions::Acceleration::cg));

// A factor of an earlier state is a preconditioner: it must not change the result.
TEST(Friction, DoesNotDependOnTheFactorAtHand) {
  std::mt19937 generator(6);
  const ContactProblem problem = frictional(30, 2, 0.2, generator);
  ContactLoad load = random_load(problem, 0.3, generator);
  const auto solver = friction_solver(problem, {});
  const ContactState first = solver->solve(load, {}).state;
  load.gap += 0.05 * random_vector(load.gap.size(), generator);
  const ContactState near = solver->solve(load, first).state;
  const ContactState cold = friction_solver(problem, {})->solve(load, {}).state;
  EXPECT_LT((near.multiplier - cold.multiplier).cwiseAbs().maxCoeff(), 1e-9 * cold.multiplier.maxCoeff());
}

}  // namespace
}  // namespace creepcontact::contact
