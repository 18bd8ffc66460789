// Trees against comparing with everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "creepcontact/mesh/box_tree.hpp"
#include "creepcontact/mesh/point_tree.hpp"

namespace creepcontact {
namespace {

TEST(BoxTree, FindsWhatComparingAllBoxesFinds) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> position(0, 1), size(0, 0.1);
  const auto random_box = [&] {
    const Vector3 corner(position(generator), position(generator), position(generator));
    return Eigen::AlignedBox3d(corner,
                               Vector3(corner + Vector3(size(generator), size(generator), 0.1 * size(generator))));
  };
  for (const std::size_t n : {0, 1, 4, 5, 333}) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (std::size_t i = 0; i < n; ++i) boxes.push_back(random_box());
    if (n > 4) boxes[3] = boxes[4];  // alike
    const mesh::BoxTree tree(boxes);
    for (int trial = 0; trial < 200; ++trial) {
      const Eigen::AlignedBox3d window = random_box();
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < n; ++i)
        if (boxes[i].intersects(window)) expected.push_back(i);
      EXPECT_EQ(tree.meeting(window), expected);
    }
  }
}

TEST(BoxTree, TouchingBoxesMeet) {
  std::vector<Eigen::AlignedBox3d> cells;  // of a lattice with spacing 1
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) cells.emplace_back(Vector3(x, y, 0), Vector3(x + 1, y + 1, 1));
  const mesh::BoxTree tree(cells);
  const Vector3 corner(2, 3, 1);
  EXPECT_EQ(tree.meeting({corner, corner}), (std::vector<std::size_t>{8, 9, 14, 15}));
  EXPECT_TRUE(tree.meeting({Vector3(0, 0, std::nextafter(1.0, 2.0)), Vector3(6, 6, 2)}).empty());
}

TEST(PointTree, FindsTheNearestInTheirOrder) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(0, 1);
  const auto random_point = [&] {
    return Vector3(coordinate(generator), coordinate(generator), coordinate(generator));
  };
  std::vector<Vector3> points;
  for (int i = 0; i < 500; ++i) points.push_back(random_point());
  const mesh::PointTree tree(points);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3 position = random_point();
    std::vector<std::pair<double, std::size_t>> expected;
    for (std::size_t i = 0; i < points.size(); ++i) expected.emplace_back((points[i] - position).norm(), i);
    std::ranges::sort(expected);
    const std::vector<mesh::Neighbour> found = tree.nearest(position, 12);
    ASSERT_EQ(found.size(), 12);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].point, expected[i].second);
      EXPECT_EQ(found[i].distance, expected[i].first);
    }
  }
  EXPECT_EQ(tree.nearest(Vector3::Zero(), 1000).size(), points.size());
}

TEST(PointTree, OrdersPointsAtOneDistanceByTheirIndex) {
  const mesh::PointTree tree(std::vector{Vector3(2, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, -1), Vector3(0, 1, 0)});
  std::vector<std::size_t> order;
  for (const mesh::Neighbour& neighbour : tree.nearest(Vector3::Zero(), 4)) order.push_back(neighbour.point);
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 2, 3, 0}));
}

}  // namespace
}  // namespace creepcontact
