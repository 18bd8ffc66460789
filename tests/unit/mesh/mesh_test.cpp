#include "creepcontact/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "unit/mesh/reference_cells.hpp"

namespace creepcontact::mesh {
namespace {

using creepcontact::test::message_of;
using creepcontact::test::says;

using Indices = std::vector<std::int64_t>;

// Two unit hexahedra on top of each other, sharing the nodes 4..7; groups "lower", "upper" and their surfaces.
Mesh two_blocks() {
  Mesh mesh;
  for (double z : {0.0, 1.0, 2.0}) {
    for (auto [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) mesh.nodes.emplace_back(x, y, z);
  }
  mesh.blocks.push_back({CellType::line2, {0, 4, 4, 8}});
  mesh.blocks.push_back({CellType::quad4, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
  mesh.blocks.push_back({CellType::hex8, {0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11}});
  const auto add = [&](const char* name, int dimension, std::vector<CellRef> cells) {
    mesh.groups[name] = {name, dimension, std::move(cells)};
  };
  add("edge", 1, {{0, 0}, {0, 1}});
  add("bottom", 2, {{1, 0}});
  add("interface", 2, {{1, 1}});
  add("ends", 2, {{1, 0}, {1, 2}});
  add("lower", 3, {{2, 0}});
  add("upper", 3, {{2, 1}});
  return mesh;
}

Vector3 normal(const Mesh& mesh, const Face& face) {
  const auto at = [&](int i) { return mesh.nodes[face.nodes[i]]; };
  return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
}

TEST(Mesh, FindsGroups) {
  const Mesh mesh = two_blocks();
  EXPECT_EQ(mesh.group("lower").dimension, 3);
  EXPECT_EQ(mesh.group("edge", 1).cells.size(), 2u);
}

TEST(Mesh, MissingGroupSuggestsTheNearestAndListsThoseOfItsDimension) {
  const Mesh mesh = two_blocks();
  EXPECT_TRUE(says(message_of<ModelError>([&] { mesh.group("botom", 2); }),
                   {"physical surface 'botom'", "'bottom'?", "bottom, ends, interface"}));
  const std::string far = message_of<ModelError>([&] { mesh.group("symmetry"); });
  EXPECT_EQ(far.find('?'), std::string::npos) << far;
  EXPECT_TRUE(says(far, {"'symmetry'", "bottom, edge, ends, interface, lower, upper"}));
  EXPECT_TRUE(says(message_of<ModelError>([&] { Mesh().group("x", 3); }), {"physical volume 'x'", "none"}));
}

TEST(Mesh, GroupOfAnotherDimensionIsNamed) {
  const Mesh mesh = two_blocks();
  EXPECT_TRUE(says(message_of<ModelError>([&] { mesh.group("bottom", 3); }),
                   {"'bottom'", "surface", "volume", "lower, upper"}));
}

TEST(Mesh, GroupNodesAreDistinctAndAscending) {
  EXPECT_EQ(group_nodes(two_blocks(), "edge"), (Indices{0, 4, 8}));
  EXPECT_EQ(group_nodes(two_blocks(), "ends"), (Indices{0, 1, 2, 3, 8, 9, 10, 11}));
}

TEST(Extract, KeepsTheBodyAndWhatLiesOnIt) {
  const Mesh parent = two_blocks();
  const BodyMesh body = extract(parent, {"upper"});
  EXPECT_EQ(body.parent_node, (Indices{4, 5, 6, 7, 8, 9, 10, 11}));
  ASSERT_EQ(body.mesh.nodes.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(body.mesh.nodes[i], parent.nodes[body.parent_node[i]]);
  const CellRef hexahedron = body.mesh.group("upper", 3).cells.at(0);
  const auto cell = body.mesh.blocks[hexahedron.block].cell(hexahedron.cell);
  EXPECT_EQ(Indices(cell.begin(), cell.end()), (Indices{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(body.mesh.groups.count("lower"), 0u);
  EXPECT_EQ(body.mesh.groups.count("bottom"), 0u);
  EXPECT_EQ(body.mesh.group("ends", 2).cells.size(), 1u);
  EXPECT_EQ(group_nodes(body.mesh, "edge"), (Indices{0, 4}));
}

TEST(Extract, JoinsRegionsWithoutDoublingCells) {
  Mesh parent = two_blocks();
  parent.groups["all"] = {"all", 3, {{2, 0}, {2, 1}}};
  const BodyMesh body = extract(parent, {"all", "lower"});
  EXPECT_EQ(body.mesh.nodes.size(), 12u);
  EXPECT_EQ(body.mesh.group("all").cells.size(), 2u);
  EXPECT_EQ(body.mesh.blocks.back().size(), 2u);
}

TEST(Extract, MissingOrWrongRegionIsAnError) {
  EXPECT_TRUE(says(message_of<ModelError>([] { extract(two_blocks(), {"uper"}); }), {"'uper'", "'upper'"}));
  EXPECT_TRUE(
      says(message_of<ModelError>([] { extract(two_blocks(), {"bottom"}); }), {"'bottom'", "surface", "volume"}));
  Mesh empty = two_blocks();
  empty.groups["hollow"] = {"hollow", 3, {}};
  EXPECT_TRUE(says(message_of<ModelError>([&] { extract(empty, {"hollow"}); }), {"volume 'hollow'", "no cells"}));
}

// A tetrahedron in a bent interface: the neighbour's face (1, 2, 3) has its nodes in the body but is no face of it.
TEST(Extract, LeavesOutFacesOfTheNeighbourAcrossABentInterface) {
  Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}, {-1, 0, 0}};
  mesh.blocks.push_back({CellType::tri3, {1, 2, 3}});
  mesh.blocks.push_back({CellType::tet4, {0, 1, 2, 3, 0, 2, 1, 4, 0, 3, 2, 5}});
  mesh.groups["face"] = {"face", 2, {{0, 0}}};
  mesh.groups["inner"] = {"inner", 3, {{1, 0}}};
  mesh.groups["outer"] = {"outer", 3, {{1, 1}, {1, 2}}};
  EXPECT_EQ(extract(mesh, {"inner"}).mesh.groups.count("face"), 1u);
  EXPECT_EQ(extract(mesh, {"outer"}).mesh.groups.count("face"), 0u);
}

TEST(BoundaryFaces, PointOutOfEachOfTwoBodiesThatShareNodes) {
  const Mesh parent = two_blocks();
  for (const auto& [region, z] : {std::pair{"lower", 1.0}, {"upper", -1.0}}) {
    const Mesh body = extract(parent, {region}).mesh;
    const auto faces = boundary_faces(body, "interface");
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].type, CellType::quad4);
    EXPECT_EQ(normal(body, faces[0]), Vector3(0, 0, z));
  }
}

TEST(BorderNodes, OfFacesAndOfCurves) {
  // Two quadrilaterals beside each other; 8 to 14 between the corners.
  const std::vector<Face> faces{{CellType::quad8, {0, 1, 4, 3, 8, 9, 10, 11}},
                                {CellType::quad8, {1, 2, 5, 4, 12, 13, 14, 9}}};
  EXPECT_EQ(border_nodes(faces), (std::set<std::int64_t>{0, 1, 2, 3, 4, 5, 8, 10, 11, 12, 13, 14}));
  const std::vector<Face> curve{
      {CellType::line3, {0, 1, 5}}, {CellType::line3, {1, 2, 6}}, {CellType::line3, {2, 3, 7}}};
  EXPECT_EQ(border_nodes(curve), (std::set<std::int64_t>{0, 3}));
}

TEST(BoundaryFaces, FacesOfNoElementAreCounted) {
  Mesh mesh = two_blocks();
  EXPECT_EQ(n_orphan_faces(mesh, "ends"), 0u);
  EXPECT_EQ(n_orphan_faces(mesh, "interface"), 0u);
  mesh.blocks[1].connectivity.insert(mesh.blocks[1].connectivity.end(), {0, 2, 4, 6});  // across the block
  mesh.groups["ends"].cells.push_back({1, 3});
  EXPECT_EQ(n_orphan_faces(mesh, "ends"), 1u);
}

TEST(BoundaryFaces, SurfaceInsideTheBodyIsAnError) {
  EXPECT_TRUE(
      says(message_of<ModelError>([] { boundary_faces(two_blocks(), "interface"); }), {"'interface'", "inside"}));
}

TEST(BoundaryFaces, SurfaceCellThatIsNoFaceIsAnError) {
  Mesh mesh = two_blocks();
  mesh.blocks[1].connectivity = {0, 1, 6, 7};
  mesh.groups = {{"cut", {"cut", 2, {{1, 0}}}}};
  EXPECT_TRUE(says(message_of<ModelError>([&] { boundary_faces(mesh, "cut"); }),
                   {"'cut'", "quad4", "(0.5, 0.5, 0.5)", "volume"}));
}

// Surface cells of order 1 on quadratic cells: the faces come with the cell's own mid nodes.
TEST(BoundaryFaces, LinearSurfaceCellsFindQuadraticFaces) {
  for (CellType type : {CellType::hex20, CellType::hex27}) {
    Mesh mesh;
    mesh.nodes = test::reference_nodes(type);
    mesh.blocks.push_back({type, {}});
    for (int i = 0; i < n_nodes(type); ++i) mesh.blocks[0].connectivity.push_back(i);
    mesh.blocks.push_back({CellType::quad4, {6, 5, 4, 7}});
    mesh.groups["top"] = {"top", 2, {{1, 0}}};
    const auto faces = boundary_faces(mesh, "top");
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(static_cast<int>(faces[0].nodes.size()), type == CellType::hex20 ? 8 : 9);
    EXPECT_EQ(normal(mesh, faces[0]), Vector3(0, 0, 1));
    for (std::int64_t node : faces[0].nodes) EXPECT_EQ(mesh.nodes[node][2], 1.0);
  }
}

}  // namespace
}  // namespace creepcontact::mesh
