#include "creepcontact/mesh/shared_nodes.hpp"

#include <gtest/gtest.h>

namespace creepcontact::mesh {
namespace {

/// Unit cubes of a row of three, in the groups "a", "b", "c"; cube "d" touches "c" along an edge.
Mesh cubes() {
  Mesh mesh;
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) mesh.nodes.emplace_back(x, y, 2.0 * z);
  CellBlock block{CellType::hex8, {}};
  const auto node = [](int x, int y, int z) { return 15 * z + 5 * y + x; };
  const auto add = [&](const char* name, int x, int y) {
    for (int z = 0; z < 2; ++z)
      for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
        block.connectivity.push_back(node(x + dx, y + dy, z));
    mesh.groups[name] = {name, 3, {{0, block.size() - 1}}};
  };
  add("a", 0, 0);
  add("b", 1, 0);
  add("c", 2, 0);
  add("d", 3, 1);
  mesh.blocks.push_back(block);
  return mesh;
}

std::vector<BodyMesh> bodies(const std::vector<std::vector<std::string>>& regions) {
  std::vector<BodyMesh> result;
  for (const auto& one : regions) result.push_back(extract(cubes(), one));
  return result;
}

TEST(SharedMesh, FacesAndNodesOfTwoBodies) {
  const std::vector<BodyMesh> cut = bodies({{"a"}, {"b", "c"}});
  const SharedMesh shared = shared_mesh(cut);
  ASSERT_EQ(shared.nodes.size(), 4u);
  for (const SharedNode& node : shared.nodes) {
    ASSERT_EQ(node.owners.size(), 2u);
    const Vector3 first = cut[0].mesh.nodes[node.owners[0].node];
    const Vector3 second = cut[1].mesh.nodes[node.owners[1].node];
    EXPECT_EQ(first, second);
    EXPECT_EQ(first.x(), 1);
  }
  ASSERT_EQ(shared.faces.size(), 1u);
  EXPECT_EQ(shared.faces[0].first, 0u);
  EXPECT_EQ(shared.faces[0].second, 1u);
  EXPECT_EQ(shared.faces[0].nodes.size(), 4u);
  EXPECT_DOUBLE_EQ(shared.faces[0].area, 2);
}

TEST(SharedMesh, EdgesAreNoFaces) {
  const SharedMesh shared = shared_mesh(bodies({{"c"}, {"d"}}));
  EXPECT_EQ(shared.nodes.size(), 2u);
  EXPECT_TRUE(shared.faces.empty());
}

TEST(SharedMesh, NothingInCommon) {
  EXPECT_TRUE(shared_mesh(bodies({{"a"}, {"c"}})).nodes.empty());
  EXPECT_TRUE(shared_mesh({}).nodes.empty());
}

}  // namespace
}  // namespace creepcontact::mesh
