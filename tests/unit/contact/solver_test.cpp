#include <gtest/gtest.h>

#include "accelerations.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/contact/geometry/polygon.hpp"
#include "problems.hpp"
#include "support/says.hpp"

namespace creepcontact::contact {
namespace {

using creepcontact::test::accelerated;
using creepcontact::test::Acceleration;
using creepcontact::test::accelerations;
using creepcontact::test::chain;
using creepcontact::test::expect_solved;

class RandomProblems : public testing::TestWithParam<double> {};

TEST_P(RandomProblems, SchwarzAgreesWithTheActiveSetMethodInEveryForm) {
  log::set_level(log::Level::error);
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    const ContactProblem problem = chain(1 + trial % 3, 3 + trial, GetParam(), generator);
    const Eigen::VectorXd gap = Eigen::VectorXd::NullaryExpr(problem.n_rows(), [&] { return normal(generator) - 0.3; });
    const ContactState reference = active_set_solver(problem)->solve({gap, {}}, {}).state;
    expect_solved(problem, {gap, {}}, reference, 1e-10);
    for (const Acceleration acceleration : accelerations) {
      const ContactResult result = schwarz_solver(problem, accelerated(acceleration))->solve({gap, {}}, {});
      EXPECT_LT((result.state.multiplier - reference.multiplier).cwiseAbs().maxCoeff(),
                1e-7 * std::max(1.0, reference.multiplier.cwiseAbs().maxCoeff()))
          << "acceleration " << static_cast<int>(acceleration) << ", trial " << trial;
    }
  }
  log::set_level(log::Level::info);
}

INSTANTIATE_TEST_SUITE_P(StiffnessRatios, RandomProblems, testing::Values(1e-3, 1.0, 1e3));

TEST(ActiveSet, TiedRowsAreAlwaysClosed) {
  std::mt19937 generator(5);
  ContactProblem problem = chain(1, 6, 1.0, generator);
  problem.nodes[2].set = AdmissibleSet::space;
  const Eigen::VectorXd gap = Eigen::VectorXd::LinSpaced(6, 1.0, 2.0);
  const ContactResult result = active_set_solver(problem)->solve({gap, {}}, {});
  EXPECT_EQ(result.state.active, std::vector<int>{2});
  EXPECT_LT(result.state.multiplier[2], 0);
  expect_solved(problem, {gap, {}}, result.state, 1e-12);
}

ContactProblem two_springs(double master_flexibility) {
  ContactProblem problem;
  problem.bodies = {{{0}, Eigen::MatrixXd::Constant(1, 1, 1.0)},
                    {{0}, Eigen::MatrixXd::Constant(1, 1, master_flexibility)}};
  problem.add_node(AdmissibleSet::half_line, 1, 0, 1);
  problem.total = Eigen::MatrixXd::Constant(1, 1, 1.0 + master_flexibility);
  return problem;
}

// One even and one odd half-sweep with the opposite fractions solve a pair of springs outright.
TEST(Schwarz, DiagonalWeightsSolveTwoSpringsInOneSweep) {
  for (const double flexibility : {1e-3, 0.2, 1.0, 30.0, 1e3}) {
    const ContactProblem problem = two_springs(flexibility);
    const Eigen::VectorXd gap = Eigen::VectorXd::Constant(1, -1.0);
    const ContactResult result = schwarz_solver(problem, {.acceleration = Acceleration::none})->solve({gap, {}}, {});
    EXPECT_NEAR(result.state.multiplier[0], 1 / (1 + flexibility), 1e-10);
    EXPECT_LE(result.iterations, 2);
  }
}

// r + 1/r < 6 is the condition for the constant 1/2: 3 + sqrt 8 = 5.83.
TEST(Schwarz, ConstantOneHalfConvergesUpToAStiffnessRatioOf5Point83) {
  const Eigen::VectorXd gap = Eigen::VectorXd::Constant(1, -1.0);
  const SchwarzOptions half{.alpha = {0.5, 0.5}, .acceleration = Acceleration::none, .max_iterations = 3000};
  const ContactProblem below = two_springs(5.7);
  const ContactResult converged = schwarz_solver(below, half)->solve({gap, {}}, {});
  EXPECT_NEAR(converged.state.multiplier[0], 1 / 6.7, 1e-9);
  EXPECT_GT(converged.iterations, 100);

  testing::internal::CaptureStderr();
  const ContactProblem above = two_springs(6.0);
  const ContactResult fallen_back = schwarz_solver(above, half)->solve({gap, {}}, {});
  EXPECT_TRUE(creepcontact::test::says(testing::internal::GetCapturedStderr(),
                                       {"Schwarz", "contact_solver.acceleration = \"cg\""}));
  EXPECT_NEAR(fallen_back.state.multiplier[0], 1 / 7.0, 1e-9);
}

TEST(Schwarz, ConjugateGradientsNeedFewIterationsAtEveryStiffnessRatio) {
  std::mt19937 generator(3);
  for (const double ratio : {1e-3, 1.0, 1e3}) {
    const ContactProblem problem = chain(1, 40, ratio, generator);
    const Eigen::VectorXd gap = Eigen::VectorXd::Constant(40, -1.0);
    const ContactResult result = schwarz_solver(problem, {})->solve({gap, {}}, {});
    expect_solved(problem, {gap, {}}, result.state, 1e-8);
    EXPECT_LE(result.iterations, 40 * result.set_changes);
  }
}

// Flexibility of a half space under unit pressures: 1/distance, the diagonal as of a square patch.
Flexibility half_space(int side, double scale) {
  Flexibility body;
  const int n = side * side;
  body.matrix.resize(n, n);
  for (int i = 0; i < n; ++i) {
    body.rows.push_back(i);
    for (int j = 0; j < n; ++j) {
      const double distance = std::hypot(i % side - j % side, i / side - j / side);
      body.matrix(i, j) = scale * (i == j ? 3.525 : 1 / distance);
    }
  }
  return body;
}

TEST(Schwarz, ThreeThousandMultipliers) {
  constexpr int side = 55;
  ContactProblem problem;
  problem.bodies = {half_space(side, 1.0), half_space(side, 0.2)};
  problem.total = problem.bodies[0].matrix + problem.bodies[1].matrix;
  for (int i = 0; i < side * side; ++i) problem.add_node(AdmissibleSet::half_line, 1, 0, 1);
  Eigen::VectorXd gap(side * side);  // a sphere
  for (int i = 0; i < side * side; ++i) {
    const int column = i % side, row = i / side;
    const double x = column - 27.3, y = row - 26.8;
    gap[i] = 1e-3 * (x * x + y * y - 500);
  }
  const ContactResult result = schwarz_solver(problem, {})->solve({gap, {}}, {});
  expect_solved(problem, {gap, {}}, result.state, 1e-8);
  EXPECT_GT(result.state.active.size(), 500u);
  EXPECT_LE(result.iterations, 15 * result.set_changes);
}

TEST(Schwarz, DampingAndAlphaOfEachBody) {
  const ContactProblem problem = two_springs(10.0);
  const Eigen::VectorXd gap = Eigen::VectorXd::Constant(1, -1.0);
  const auto sweeps = [&](SchwarzOptions options) {
    options.acceleration = Acceleration::none;
    options.max_iterations = 2000;
    const ContactResult result = schwarz_solver(problem, options)->solve({gap, {}}, {});
    EXPECT_NEAR(result.state.multiplier[0], 1 / 11.0, 1e-9);
    return result.iterations;
  };
  const int outright = sweeps({});
  EXPECT_GT(sweeps({.damping = 0.5}), 10 * outright);
  // Beyond the bound of the constant 1/2, smaller constants or damping still converge.
  EXPECT_LT(sweeps({.alpha = {0.2, 0.2}}), 2000);
  EXPECT_LT(sweeps({.alpha = {0.5, 0.5}, .damping = 0.3}), 2000);
  EXPECT_NE(sweeps({.alpha = {0.2, {}}}), sweeps({.alpha = {{}, 0.2}}));
}

TEST(Schwarz, WarnsOnceHoweverManySweepsFail) {
  const ContactProblem problem = two_springs(10.0);
  const auto solver = schwarz_solver(problem, {.alpha = {0.5, 0.5}, .acceleration = Acceleration::none});
  testing::internal::CaptureStderr();
  for (const double gap : {-1.0, -2.0, -3.0}) solver->solve({Eigen::VectorXd::Constant(1, gap), {}}, {});
  const std::string warnings = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 1) << warnings;
}

TEST(Schwarz, AndersonMustBeHandedOver) {
  const ContactProblem problem = two_springs(1.0);
  EXPECT_THROW(schwarz_solver(problem, {.acceleration = Acceleration::anderson}), std::invalid_argument);
}

TEST(ContactSolver, RecorderSeesEveryIteration) {
  struct Recorder final : IterationRecorder {
    void begin_solve(double /*time*/) override {}
    void record(const Iteration& iteration) override { seen.push_back(iteration); }
    std::vector<Iteration> seen;
  };
  std::mt19937 generator(8);
  const ContactProblem problem = chain(2, 9, 3.0, generator);
  const Eigen::VectorXd gap = Eigen::VectorXd::LinSpaced(18, -1.0, 0.5);
  for (const Acceleration acceleration : accelerations) {
    Recorder recorder;
    const auto solver = schwarz_solver(problem, accelerated(acceleration));
    solver->set_recorder(&recorder);
    const ContactResult result = solver->solve({gap, {}}, {});
    ASSERT_EQ(recorder.seen.size(), static_cast<std::size_t>(result.iterations));
    EXPECT_EQ(recorder.seen.back().active, result.state.active.size());
    EXPECT_LE(recorder.seen.back().residual, SchwarzOptions().tolerance);
    EXPECT_EQ(recorder.seen.front().iteration, 1);
  }
}

TEST(ContactSolver, WarmStartDoesNotChangeTheResult) {
  std::mt19937 generator(9);
  const ContactProblem problem = chain(2, 12, 10.0, generator);
  std::normal_distribution<double> normal;
  const Eigen::VectorXd gap = Eigen::VectorXd::NullaryExpr(24, [&] { return normal(generator); });
  const ContactState warm = schwarz_solver(problem, {})->solve({-gap, {}}, {}).state;
  const Eigen::VectorXd cold_result = schwarz_solver(problem, {})->solve({gap, {}}, {}).state.multiplier;
  const Eigen::VectorXd warm_result = schwarz_solver(problem, {})->solve({gap, {}}, warm).state.multiplier;
  EXPECT_LT((cold_result - warm_result).cwiseAbs().maxCoeff(), 1e-8 * cold_result.maxCoeff());
}

TEST(Polygon, ClippingGivesTheIntersection) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Polygon shifted{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}};
  const Polygon triangle{{0, 0}, {2, 0}, {0, 2}};
  const Polygon away{{3, 3}, {4, 3}, {4, 4}};
  Polygon result, work;
  clip(square, shifted, result, work);
  EXPECT_NEAR(area(result), 0.25, 1e-15);
  clip(shifted, triangle, result, work);
  EXPECT_NEAR(area(result), 0.5, 1e-15);
  clip(square, away, result, work);
  EXPECT_TRUE(result.empty());
  clip(square, square, result, work);
  EXPECT_NEAR(area(result), 1.0, 1e-15);
}

}  // namespace
}  // namespace creepcontact::contact
