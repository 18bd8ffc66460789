/// Links between nodes: cyclic symmetry and rigid surfaces.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/mechanics/constraints.hpp"
#include "support/says.hpp"

namespace creepcontact::mechanics {
namespace links_tests {
namespace {

const Matrix3 sixth = Eigen::AngleAxisd(std::numbers::pi / 3, Vector3::UnitZ()).toRotationMatrix();

/// Four nodes on the first face of a sector, their images on the second one, and one between the two.
std::vector<Vector3> sector_nodes() {
  std::vector<Vector3> nodes{{1, 0, 0}, {2, 0, 0}, {1, 0, 1}, {2, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) nodes.emplace_back(sixth * nodes[i]);
  nodes.emplace_back(1, 0.8, 0.5);
  return nodes;
}

NodeLinks sector_links() {
  NodeLinks links;
  for (std::int64_t i = 0; i < 4; ++i) links.turned.push_back({4 + i, i, sixth});
  return links;
}

Eigen::VectorXd random(std::int64_t n) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(generator); });
}

/// Of all nodes, at time t.
Eigen::VectorXd displacement(const Constraints& constraints, double t, const Eigen::VectorXd& free) {
  std::vector<double> prescribed(constraints.n_full()), full(constraints.n_full());
  constraints.prescribed(t, prescribed);
  constraints.expand({free.data(), static_cast<std::size_t>(free.size())}, prescribed, full);
  return Eigen::Map<Eigen::VectorXd>(full.data(), std::ssize(full));
}

/// Virtual work: forces on the free dofs do the work that the forces on the nodes do.
void expect_transposed(const Constraints& constraints) {
  const Eigen::VectorXd force = random(constraints.n_full()), free = random(constraints.n_free());
  const Eigen::VectorXd moved =
      displacement(constraints, 0, free) - displacement(constraints, 0, Eigen::VectorXd::Zero(free.size()));
  std::vector<double> restricted(constraints.n_free());
  constraints.restrict_to_free({force.data(), static_cast<std::size_t>(force.size())}, restricted);
  EXPECT_NEAR(force.dot(moved), free.dot(Eigen::Map<Eigen::VectorXd>(restricted.data(), free.size())), 1e-13);
}

TEST(Links, SecondFaceFollowsTheFirst) {
  const std::vector<Vector3> nodes = sector_nodes();
  const Support plane{"plane", {0, 1}, {Vector3::UnitZ()}, 0.25};
  const Constraints constraints(nodes, {plane}, sector_links());
  EXPECT_EQ(constraints.n_free(), 3 * 5 - 2);
  const Eigen::VectorXd u = displacement(constraints, 0, random(constraints.n_free()));
  for (Index i = 0; i < 4; ++i) EXPECT_LT((u.segment<3>(3 * (4 + i)) - sixth * u.segment<3>(3 * i)).norm(), 1e-15) << i;
  EXPECT_EQ(u[2], 0.25);
  EXPECT_EQ(u[3 * 4 + 2], 0.25) << "the image of a supported node";
  expect_transposed(constraints);
}

TEST(Links, SupportOfAnImageActsOnTheNodeItFollows) {
  const Support on_image{"on_image", {4}, {sixth * Vector3::UnitX()}, 0.5};
  const Constraints constraints(sector_nodes(), {on_image}, sector_links());
  const Eigen::VectorXd u = displacement(constraints, 0, random(constraints.n_free()));
  EXPECT_NEAR(u[0], 0.5, 1e-15);
  EXPECT_EQ(constraints.n_held(0), 1);
  EXPECT_EQ(constraints.n_held(4), 1);
}

TEST(Links, ANodeOnTheAxisMovesAlongItAlone) {
  std::vector<Vector3> nodes = sector_nodes();
  nodes.emplace_back(0, 0, 0.5);
  NodeLinks links = sector_links();
  links.turned.push_back({9, 9, sixth});
  const Constraints constraints(nodes, {}, links);
  EXPECT_EQ(constraints.n_free(), 3 * 5 + 1);
  const Eigen::VectorXd u = displacement(constraints, 0, random(constraints.n_free()));
  EXPECT_NEAR(u.segment<2>(27).norm(), 0, 1e-15);
  EXPECT_NE(u[29], 0);
}

TEST(Links, MotionsOfASectorAreThoseAlongAndAboutTheAxis) {
  const std::vector<Vector3> nodes = sector_nodes();
  const auto conditions = Constraints(nodes, {}, sector_links()).conditions_on_motions(nodes, {0.7, 0.3, 0.2}, 2.0);
  const Eigen::VectorXd values = linalg::singular_values(conditions).values;
  EXPECT_EQ((values.array() > 1e-12 * values[0]).count(), 4);
}

NodeLinks rigid_links() {
  NodeLinks links;
  NodeLinks::Rigid plate;
  plate.on = "plate";
  plate.nodes = {0, 1, 2, 3};
  plate.origin = {1.5, 0, 0.5};
  links.rigid.push_back(plate);
  return links;
}

TEST(Links, RigidSurfaceKeepsItsShape) {
  const std::vector<Vector3> nodes = sector_nodes();
  const Constraints constraints(nodes, {}, rigid_links());
  EXPECT_EQ(constraints.n_free(), 6 + 3 * 5);
  const Eigen::VectorXd u = displacement(constraints, 0, random(constraints.n_free()));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3 moved = u.segment<3>(3 * static_cast<Index>(i)) - u.segment<3>(3 * static_cast<Index>(j));
      EXPECT_NEAR(moved.dot(nodes[i] - nodes[j]), 0, 1e-14) << "small rotations change no distance";
    }
  expect_transposed(constraints);
}

TEST(Links, RigidSurfaceTakesWhatIsPrescribed) {
  const std::vector<Vector3> nodes = sector_nodes();
  NodeLinks links = rigid_links();
  links.rigid[0].displacement = {Function(0.1), std::nullopt, Function(0.3)};
  links.rigid[0].rotation = {Function(0.0), Function(0.02), std::nullopt};
  const Constraints constraints(nodes, {}, links);
  EXPECT_EQ(constraints.n_free(), 2 + 3 * 5);
  const Eigen::VectorXd u = displacement(constraints, 0, Eigen::VectorXd::Zero(constraints.n_free()));
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3 expected = Vector3(0.1, 0, 0.3) + Vector3(0, 0.02, 0).cross(nodes[i] - Vector3(1.5, 0, 0.5));
    EXPECT_LT((u.segment<3>(3 * static_cast<Index>(i)) - expected).norm(), 1e-14) << i;
  }
  expect_transposed(constraints);
}

std::string refusal(const std::vector<Support>& supports, const NodeLinks& links) {
  return creepcontact::test::message_of<ModelError>(
      [&] { const Constraints constraints(sector_nodes(), supports, links); });
}

TEST(Links, ContradictionsAreRefused) {
  NodeLinks twice = rigid_links();
  twice.rigid.push_back(twice.rigid[0]);
  twice.rigid[1].on = "other";
  EXPECT_TRUE(creepcontact::test::says(refusal({}, twice), {"rigid surfaces 'plate' and 'other'", "nodes"}));

  const std::vector<Support> torn{{"left", {0}, {Vector3::UnitX()}, 0.0}, {"right", {1}, {Vector3::UnitX()}, 0.1}};
  EXPECT_TRUE(creepcontact::test::says(refusal(torn, rigid_links()), {"rigid surface 'plate'", "prescribed", "t = "}));

  NodeLinks half = sector_links();
  half.rigid = rigid_links().rigid;
  half.rigid[0].nodes = {0, 1, 8};
  EXPECT_TRUE(creepcontact::test::says(refusal({}, half), {"rigid surface 'plate'", "face of cyclic symmetry"}));
}

}  // namespace
}  // namespace links_tests
}  // namespace creepcontact::mechanics
