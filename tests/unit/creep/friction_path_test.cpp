/// The path of friction within a step, on condensed problems without a mesh, against very many equal substeps.
#include "../../../src/creep/friction_path.hpp"

#include <gtest/gtest.h>

#include "../../../src/creep/load_course.hpp"
#include "friction_joint.hpp"

namespace creepcontact::creep {
namespace friction_path_tests {
namespace {

using friction_joints::Joint;
using friction_joints::Loads;

double shear_error(const SlipAdvance& slip, const PathPoint& found, const PathPoint& exact) {
  double error = 0, limit = 0;
  for (const SlipNode& node : slip.nodes()) {
    const Eigen::VectorXd difference =
        node.tangential(found.contact.multiplier) - node.tangential(exact.contact.multiplier);
    error = std::max(error, difference.norm());
    limit = std::max(limit, node.at(exact.contact).friction * exact.contact.multiplier[node.normal_row]);
  }
  return error / limit;
}

class FollowedPath : public testing::TestWithParam<int> {};

TEST_P(FollowedPath, EndsWhereManyEqualSubstepsEnd) {
  int longer_paths = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Joint joint(12, GetParam(), seed);
    const SlipAdvance slip(joint.problem, joint.pairs);
    const Loads loads(joint, seed);
    const PathPoint begin = joint.at_rest(loads.at(0));
    const PathPoint once = joint.next(slip, begin, loads.at(1), 1);
    PathPoint exact = begin;
    constexpr int many = 2000;
    for (int k = 1; k <= many; ++k) exact = joint.next(slip, exact, loads.at(double(k) / many), double(k) / many);

    FrictionPath::Limits limits;
    limits.tolerance = 1e-3;
    int solves = 0;
    FrictionPath path(
        joint.problem, slip, limits, [&](double part) { return joint.load(loads.at(part)); },
        [&](const contact::ContactLoad& load, const contact::ContactState& from, double) {
          ++solves;
          return joint.solver->solve(load, from);
        });
    const auto points = path.follow(begin, once);
    ASSERT_TRUE(points);
    EXPECT_EQ(path.unresolved(), 0);
    const PathPoint& end = points->back();
    EXPECT_EQ(end.friction.time, 1);
    EXPECT_LT(shear_error(slip, end, exact), 2e-3) << seed;
    const double slid = exact.friction.path.maxCoeff();
    EXPECT_LT((end.friction.slip - exact.friction.slip).cwiseAbs().maxCoeff(), 1e-3 * slid) << seed;
    EXPECT_NEAR(end.friction.dissipated[0], exact.friction.dissipated[0], 3e-3 * exact.friction.dissipated[0]) << seed;
    EXPECT_LT((end.friction.path - exact.friction.path).cwiseAbs().maxCoeff(), 0.01 * slid) << seed;
    EXPECT_LT(solves, 400);
    if (shear_error(slip, once, exact) > 0.05) ++longer_paths;
    for (std::size_t k = 1; k < points->size(); ++k) {
      EXPECT_GT((*points)[k].friction.time, (*points)[k - 1].friction.time);
      EXPECT_GE(((*points)[k].friction.path - (*points)[k - 1].friction.path).minCoeff(), 0);
      EXPECT_GE((*points)[k].friction.dissipated[0], (*points)[k - 1].friction.dissipated[0] * (1 - 1e-12));
    }
  }
  EXPECT_GT(longer_paths, 5) << "one step is far off";
}

INSTANTIATE_TEST_SUITE_P(Tangents, FollowedPath, testing::Values(1, 2));

TEST(FrictionPath, CostsNothingWhereNothingMoves) {
  const Joint joint(8, 2, 3);
  const SlipAdvance slip(joint.problem, joint.pairs);
  const Loads loads(joint, 3);
  const PathPoint begin = joint.at_rest(loads.at(0)), end = joint.next(slip, begin, loads.at(0), 1);
  FrictionPath path(
      joint.problem, slip, {}, [&](double) { return joint.load(loads.at(0)); },
      [&](const contact::ContactLoad&, const contact::ContactState&, double) -> contact::ContactResult {
        ADD_FAILURE() << "no solve is needed";
        return {};
      });
  const auto points = path.follow(begin, end);
  ASSERT_TRUE(points);
  EXPECT_EQ(points->size(), 2);
}

// Slip that sets on within a substep does so at the limit there, and not at that of the end.
TEST(FrictionPath, EnergyWhereThePressureFallsWhileNodesBeginToSlip) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Joint joint(3, 1, seed);
    const SlipAdvance slip(joint.problem, joint.pairs);
    Loads loads(joint, seed);
    for (const SlipNode& node : slip.nodes()) {
      loads.first[node.normal_row] = -1;
      loads.last[node.normal_row] = -0.3;
      node.tangential(loads.first).setZero();
      node.tangential(loads.last) *= 0.3;
    }
    const auto solve = [&](const contact::ContactLoad& load, const contact::ContactState& from, double) {
      return joint.solver->solve(load, from);
    };
    const PathPoint begin = joint.at_rest(loads.first), once = joint.next(slip, begin, loads.last, 1);
    FrictionPath path(
        joint.problem, slip, {}, [&](double part) { return joint.load(loads.at(part)); }, solve);
    const auto points = path.follow(begin, once);
    ASSERT_TRUE(points);
    PathPoint exact = begin;
    constexpr int many = 4000;
    for (int k = 1; k <= many; ++k) exact = joint.next(slip, exact, loads.at(double(k) / many), double(k) / many);
    const double energy = exact.friction.dissipated[0];
    EXPECT_NEAR(points->back().friction.dissipated[0], energy, 1.5e-3 * energy) << seed;
  }
}

// The coefficient of friction falls for a while, and the loads do not change: what has slipped does not come back.
TEST(FrictionPath, SeesFrictionThatFallsForAWhile) {
  Joint joint(8, 1, 5);
  const SlipAdvance slip(joint.problem, joint.pairs);
  Loads loads(joint, 5);
  for (const SlipNode& node : slip.nodes()) {
    loads.first[node.normal_row] = -1;
    node.tangential(loads.first).setConstant(0.3);
  }
  const PathPoint begin = joint.at_rest(loads.first), once = joint.next(slip, begin, loads.first, 1);
  const auto with = [&](double part) {
    contact::ContactLoad load = joint.load(loads.first);
    load.friction.coefficient.setConstant(joint.mu * (1 - 0.9 * std::exp(-std::pow((part - 0.5) / 0.1, 2))));
    return load;
  };
  FrictionPath path(joint.problem, slip, {}, with,
                    [&](const contact::ContactLoad& load, const contact::ContactState& from, double) {
                      return joint.solver->solve(load, from);
                    });
  const auto points = path.follow(begin, once);
  ASSERT_TRUE(points);
  PathPoint exact = begin;
  constexpr int many = 1000;
  for (int k = 1; k <= many; ++k) {
    const double t = double(k) / many;
    contact::ContactLoad load = with(t);
    const Eigen::VectorXd reference = slip.reference(exact, t);
    load.gap -= reference;
    load.friction.direction = exact.friction.direction;
    const contact::ContactResult found = joint.solver->solve(load, exact.contact);
    exact = {found.state, slip.advanced(exact, t, reference, found.state, found.gap)};
  }
  EXPECT_GT(shear_error(slip, once, exact), 0.3);
  EXPECT_LT(shear_error(slip, points->back(), exact), 5e-3);
}

TEST(LoadCourse, MeetsWhatItWasMadeOf) {
  using Deviation = LoadCourse::Deviation;
  const auto exact = [](double x) {
    return Deviation{Eigen::VectorXd::Constant(1, std::sin(9 * x) * x * (1 - x)), Eigen::VectorXd(0)};
  };
  const LoadCourse course(exact(0), exact,
                          [](const Deviation& a, const Deviation& b) { return std::abs(a.gap[0] - b.gap[0]) < 1e-3; });
  EXPECT_TRUE(course.is_resolved());
  for (double x = 0; x <= 1; x += 1.0 / 64) EXPECT_NEAR(course.at(x).gap[0], exact(x).gap[0], 1e-3);
  const LoadCourse jump(
      {Eigen::VectorXd::Zero(1), Eigen::VectorXd(0)},
      [](double x) {
        return Deviation{Eigen::VectorXd::Constant(1, x < 0.3), Eigen::VectorXd(0)};
      },
      [](const Deviation& a, const Deviation& b) { return std::abs(a.gap[0] - b.gap[0]) < 1e-3; });
  EXPECT_FALSE(jump.is_resolved());
}

}  // namespace
}  // namespace friction_path_tests
}  // namespace creepcontact::creep
