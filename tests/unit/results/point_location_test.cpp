#include "../../../src/results/point_location.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/mechanics/meshes.hpp"

namespace creepcontact::results::test {
namespace {

using creepcontact::test::box_mesh;
using creepcontact::test::mapped;

/// The place that a location's weights give.
Vector3 interpolated(const mesh::Mesh& mesh, const PointLocation& location) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < location.nodes.size(); ++i)
    sum += location.weights[i] * mesh.nodes[static_cast<std::size_t>(location.nodes[i])];
  return sum;
}

double sum_of_weights(const PointLocation& location) {
  double sum = 0;
  for (const double weight : location.weights) sum += weight;
  return sum;
}

class Locate : public testing::TestWithParam<mesh::CellType> {};

TEST_P(Locate, PointsInsideADistortedMesh) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {3, 2, 2}, {3, 1, 2}, {0, 0, -1}, 0.2);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 100; ++i) {
    const Vector3 at(3 * share(generator), share(generator), 2 * share(generator) - 1);
    const auto found = locate(mesh, at);
    ASSERT_TRUE(found) << at.transpose();
    EXPECT_LT(found->distance, 1e-10) << at.transpose();
    EXPECT_EQ(found->place, at);
    EXPECT_LT((interpolated(mesh, *found) - at).norm(), 1e-10) << at.transpose();
    EXPECT_NEAR(sum_of_weights(*found), 1, 1e-12);
  }
}

TEST_P(Locate, NodesAndCorners) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2}, Vector3::Ones(), Vector3::Zero(), 0.2);
  for (const Vector3& node : mesh.nodes) {
    const auto found = locate(mesh, node);
    ASSERT_TRUE(found);
    EXPECT_LT(found->distance, 1e-10) << node.transpose();
    EXPECT_LT((interpolated(mesh, *found) - node).norm(), 1e-10) << node.transpose();
  }
}

TEST_P(Locate, PointsJustOutsideAreLaidOntoTheSurface) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2});
  const auto found = locate(mesh, {0.3, 0.6, 1.05});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance, 0.05, 0.01);  // elements need not be met at their nearest place exactly
  EXPECT_NEAR(interpolated(mesh, *found).z(), 1, 1e-10);
}

TEST_P(Locate, FarPointsAreNotFound) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2});
  EXPECT_FALSE(locate(mesh, {0.5, 0.5, 1.6}));
  EXPECT_FALSE(locate(mesh, {-3, 0.5, 0.5}));
  EXPECT_FALSE(locate(mesh, {2, 2, 2}));
}

INSTANTIATE_TEST_SUITE_P(Types, Locate, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

TEST(LocateCurved, PointsOfTheTrueCircleOutsideItsChords) {
  // A quarter of a ring by linear elements: the arc lies outside them by 2 %.
  const mesh::Mesh ring = mapped(box_mesh(mesh::CellType::hex8, {2, 4, 1}), [](const Vector3& x) {
    const double r = 1 + x.x(), angle = x.y() * std::numbers::pi / 2;
    return Vector3(r * std::cos(angle), r * std::sin(angle), x.z());
  });
  for (int i = 0; i <= 16; ++i) {
    const double angle = i / 16.0 * std::numbers::pi / 2;
    const Vector3 at(2 * std::cos(angle), 2 * std::sin(angle), 0.5);
    const auto found = locate(ring, at);
    ASSERT_TRUE(found) << i;
    EXPECT_LT((interpolated(ring, *found) - at).norm(), 0.04) << i;
    EXPECT_EQ(found->place, at);
  }
}

}  // namespace
}  // namespace creepcontact::results::test
