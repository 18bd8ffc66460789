#include "creepcontact/mesh/cell_faces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "unit/mesh/reference_cells.hpp"

namespace creepcontact::mesh {
namespace {

class VolumeCell : public testing::TestWithParam<CellType> {
 protected:
  Vector3 node(int i) const { return nodes_.at(i); }
  Vector3 centre() const {
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < n_corners(GetParam()); ++i) sum += node(i);
    return sum / n_corners(GetParam());
  }
  // Half the cross product of the diagonals (quadrilateral) or of two sides (triangle).
  Vector3 area_vector(const LocalFace& face) const {
    const auto& n = face.nodes;
    if (n_corners(face.type) == 3) return 0.5 * (node(n[1]) - node(n[0])).cross(node(n[2]) - node(n[0]));
    return 0.5 * (node(n[2]) - node(n[0])).cross(node(n[3]) - node(n[1]));
  }

 private:
  std::vector<Vector3> nodes_ = test::reference_nodes(GetParam());
};

TEST_P(VolumeCell, FaceNormalsPointOutward) {
  for (const LocalFace& face : cell_faces(GetParam())) {
    ASSERT_EQ(static_cast<int>(face.nodes.size()), n_nodes(face.type));
    EXPECT_GT(area_vector(face).dot(node(face.nodes[0]) - centre()), 0.1);
  }
}

TEST_P(VolumeCell, FacesCloseTheSurfaceOnce) {
  Vector3 sum = Vector3::Zero();
  double volume = 0;  // divergence theorem: flat faces, so x.n is constant on each
  for (const LocalFace& face : cell_faces(GetParam())) {
    sum += area_vector(face);
    volume += area_vector(face).dot(node(face.nodes[0])) / 3;
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-15);
  const int corners = n_corners(GetParam());
  EXPECT_NEAR(volume, corners == 8 ? 8.0 : corners == 6 ? 1.0 : 1.0 / 6, 1e-14);
}

TEST_P(VolumeCell, MidNodesOfFacesLieBetweenTheirCorners) {
  for (const LocalFace& face : cell_faces(GetParam())) {
    const std::size_t corners = n_corners(face.type);
    Vector3 mean = Vector3::Zero();
    for (std::size_t i = 0; i < corners; ++i) {
      mean += node(face.nodes[i]) / static_cast<double>(corners);
      if (order(face.type) == 1) continue;
      const Vector3 middle = 0.5 * (node(face.nodes[i]) + node(face.nodes[(i + 1) % corners]));
      EXPECT_EQ(node(face.nodes[corners + i]), middle);
    }
    if (face.type == CellType::quad9) {
      EXPECT_EQ(node(face.nodes[8]), mean);
    }
  }
}

TEST_P(VolumeCell, EdgesNumberTheMidNodes) {
  const auto& edges = cell_edges(GetParam());
  // Euler: corners - edges + faces = 2
  EXPECT_EQ(n_corners(GetParam()) - static_cast<int>(edges.size()) + static_cast<int>(cell_faces(GetParam()).size()),
            2);
  if (order(GetParam()) == 1) return;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vector3 middle = 0.5 * (node(edges[i][0]) + node(edges[i][1]));
    EXPECT_EQ(node(n_corners(GetParam()) + static_cast<int>(i)), middle) << "edge " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(CellFaces, VolumeCell, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& cell) { return std::string(name(cell.param)); });

TEST(CellFaces, TypesFollowTheCell) {
  EXPECT_EQ(cell_faces(CellType::hex8)[0].type, CellType::quad4);
  EXPECT_EQ(cell_faces(CellType::hex20)[0].type, CellType::quad8);
  EXPECT_EQ(cell_faces(CellType::hex27)[0].type, CellType::quad9);
  EXPECT_EQ(cell_faces(CellType::tet10)[0].type, CellType::tri6);
  EXPECT_EQ(cell_faces(CellType::wedge6)[1].type, CellType::tri3);
  EXPECT_EQ(cell_faces(CellType::wedge15)[2].type, CellType::quad8);
  EXPECT_EQ(cell_faces(CellType::quad9)[3].type, CellType::line3);
  EXPECT_EQ(cell_faces(CellType::tri3)[0].type, CellType::line2);
  EXPECT_TRUE(cell_faces(CellType::line3).empty());
  EXPECT_TRUE(cell_edges(CellType::point1).empty());
}

TEST(CellType, PropertiesAreConsistent) {
  std::set<std::string_view> names;
  for (const CellType type : cell_types()) {
    names.insert(name(type));
    // The name ends in the number of nodes; a linear cell is all corners.
    EXPECT_TRUE(name(type).ends_with(std::to_string(n_nodes(type)))) << name(type);
    EXPECT_EQ(order(type) == 1, n_nodes(type) == n_corners(type)) << name(type);
  }
  EXPECT_EQ(names.size(), cell_types().size());
  EXPECT_EQ(cell_types().front(), CellType::point1);
  EXPECT_EQ(cell_types().back(), CellType::wedge15);
  for (const CellType type : cell_types())
    EXPECT_EQ(std::ranges::count(volume_cell_types(), type), dimension(type) == 3 ? 1 : 0) << name(type);
  EXPECT_EQ(dimension(CellType::point1), 0);
  EXPECT_EQ(dimension(CellType::line3), 1);
  EXPECT_EQ(dimension(CellType::quad9), 2);
  EXPECT_EQ(dimension(CellType::wedge15), 3);
}

}  // namespace
}  // namespace creepcontact::mesh
