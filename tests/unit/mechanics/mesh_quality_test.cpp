/// Folded quadratic elements.
#include "creepcontact/mechanics/mesh_quality.hpp"

#include <gtest/gtest.h>

#include "support/mechanics/meshes.hpp"

namespace creepcontact::test {
namespace {

TEST(FoldedElements, AreFoundAtTheirCorners) {
  for (const CellType type : {CellType::tet10, CellType::hex20, CellType::hex27, CellType::wedge15}) {
    mesh::Mesh mesh = box_mesh(type, {2, 1, 1}, {2, 1, 1});
    EXPECT_TRUE(mechanics::folded_elements(mesh).empty()) << mesh::name(type);
    // The mid-edge node of the bottom edge at the origin moves past the quarter point.
    for (Vector3& x : mesh.nodes)
      if ((x - Vector3(0.5, 0, 0)).norm() < 1e-12) x.x() = 0.2;
    const std::vector<Vector3> folded = mechanics::folded_elements(mesh);
    ASSERT_FALSE(folded.empty()) << mesh::name(type);
    EXPECT_LT(folded[0].x(), 1.0) << mesh::name(type);
  }
}

TEST(FoldedElements, LinearElementsHaveNoMidEdgeNodes) {
  EXPECT_TRUE(mechanics::folded_elements(box_mesh(CellType::hex8, {1, 1, 1})).empty());
}

}  // namespace
}  // namespace creepcontact::test
