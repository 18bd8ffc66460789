#include "../../../src/results/point_location.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/mechanics/meshes.hpp"

namespace creepcontact::results::test {
namespace {

using creepcontact::test::box_mesh;
using creepcontact::test::mapped;

/// The place that a location's weights give.
Vector3 interpolated(const mesh::Mesh& mesh, const PointLocation& location) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < location.nodes.size(); ++i) sum += location.weights[i] * mesh.nodes[location.nodes[i]];
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
  const PointLocator locator(mesh);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 100; ++i) {
    const Vector3 at(3 * share(generator), share(generator), 2 * share(generator) - 1);
    const auto found = locator.locate(at);
    ASSERT_TRUE(found) << at.transpose();
    EXPECT_LT(found->distance, 1e-10) << at.transpose();
    EXPECT_EQ(found->position, at);
    EXPECT_LT((interpolated(mesh, *found) - at).norm(), 1e-10) << at.transpose();
    EXPECT_NEAR(sum_of_weights(*found), 1, 1e-12);
  }
}

TEST_P(Locate, NodesAndCorners) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2}, Vector3::Ones(), Vector3::Zero(), 0.2);
  const PointLocator locator(mesh);
  for (const Vector3& node : mesh.nodes) {
    const auto found = locator.locate(node);
    ASSERT_TRUE(found);
    EXPECT_LT(found->distance, 1e-10) << node.transpose();
    EXPECT_LT((interpolated(mesh, *found) - node).norm(), 1e-10) << node.transpose();
  }
}

TEST_P(Locate, PointsJustOutsideAreLaidOntoTheSurface) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2});
  const auto found = PointLocator(mesh).locate({0.3, 0.6, 1.05});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance, 0.05, 0.01);  // elements need not be met at their nearest place exactly
  EXPECT_NEAR(interpolated(mesh, *found).z(), 1, 1e-10);
}

TEST_P(Locate, FarPointsAreNotFound) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2});
  const PointLocator locator(mesh);
  EXPECT_FALSE(locator.locate({0.5, 0.5, 1.6}));
  EXPECT_FALSE(locator.locate({-3, 0.5, 0.5}));
  EXPECT_FALSE(locator.locate({2, 2, 2}));
}

INSTANTIATE_TEST_SUITE_P(Types, Locate, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

TEST(LocateInBlocks, NumbersAreThoseOfAllVolumeCells) {
  mesh::Mesh mesh = box_mesh(mesh::CellType::hex8, {4, 1, 1}, {4, 1, 1});
  const auto volume =
      std::ranges::find(mesh.blocks, mesh::CellType::hex8, [](const mesh::CellBlock& block) { return block.type; });
  const auto middle = volume->connectivity.begin() + 2 * mesh::n_nodes(mesh::CellType::hex8);
  mesh::CellBlock second{mesh::CellType::hex8, {middle, volume->connectivity.end()}};
  volume->connectivity.erase(middle, volume->connectivity.end());
  mesh.blocks.push_back(std::move(second));  // behind the blocks of surfaces
  const PointLocator locator(mesh);
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const auto found = locator.locate({static_cast<double>(cell) + 0.25, 0.5, 0.5});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->element, cell);
  }
}

TEST(LocateCurved, PointsOfTheTrueCircleOutsideItsChords) {
  // A quarter of a ring by linear elements: the arc lies outside them by 2 %.
  const mesh::Mesh ring = mapped(box_mesh(mesh::CellType::hex8, {2, 4, 1}), [](const Vector3& x) {
    const double r = 1 + x.x(), angle = x.y() * std::numbers::pi / 2;
    return Vector3(r * std::cos(angle), r * std::sin(angle), x.z());
  });
  const PointLocator locator(ring);
  for (int i = 0; i <= 16; ++i) {
    const double angle = i / 16.0 * std::numbers::pi / 2;
    const Vector3 at(2 * std::cos(angle), 2 * std::sin(angle), 0.5);
    const auto found = locator.locate(at);
    ASSERT_TRUE(found) << i;
    EXPECT_LT((interpolated(ring, *found) - at).norm(), 0.04) << i;
    EXPECT_EQ(found->position, at);
  }
}

}  // namespace
}  // namespace creepcontact::results::test
