/// Meshes of sections: what import turns, and what it refuses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../../../../src/io/msh/msh_reader.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/io/msh/gmsh_reader.hpp"
#include "support/says.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using settings::Analysis;

/// One cell of type `gmsh_type` on the unit square, its nodes in the order of the text.
std::string one_cell(int gmsh_type, const std::string& nodes, const std::string& coordinates, int n_nodes) {
  return fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"plate\"\n$EndPhysicalNames\n"
      "$Nodes\n{}\n{}$EndNodes\n$Elements\n1\n1 {} 2 1 1 {}\n$EndElements\n",
      n_nodes, coordinates, gmsh_type, nodes);
}

const std::string square =
    "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0.5 0 0\n6 1 0.5 0\n7 0.5 1 0\n8 0 0.5 0\n9 0.5 0.5 0\n";

/// Corners counter-clockwise, and every middle node between its corners.
void expect_in_order(const mesh::Mesh& mesh) {
  const mesh::CellBlock& block = mesh.blocks.at(0);
  const auto cell = block.cell(0);
  const std::size_t n = mesh::n_corners(block.type);
  const auto at = [&](std::size_t i) { return mesh.nodes[cell[i]]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 side = at((i + 1) % n) - at(i), next = at((i + 2) % n) - at(i);
    EXPECT_GT(side.x() * next.y() - side.y() * next.x(), 0) << mesh::name(block.type);
    if (mesh::order(block.type) == 2) {
      EXPECT_EQ(at(n + i), (at(i) + at((i + 1) % n)) / 2) << mesh::name(block.type);
    }
  }
}

TEST(PlaneMesh, ClockwiseCellsAreTurned) {
  const mesh::Section plane{Analysis::plane_strain};
  const auto read = [&](int type, const std::string& nodes, int n) {
    return read_msh(one_cell(type, nodes, square, n), "m.msh", plane);
  };
  expect_in_order(read(3, "1 2 3 4", 9));
  expect_in_order(read(3, "1 4 3 2", 9));
  expect_in_order(read(2, "1 3 2", 9));
  expect_in_order(read(16, "1 4 3 2 8 7 6 5", 9));
  expect_in_order(read(10, "1 4 3 2 8 7 6 5 9", 9));
  expect_in_order(read(9, "1 3 2 9 6 5", 9));
}

std::string error_of(const mesh::Section& section, const std::string& coordinates) {
  return test::message_of<ModelError>([&] { read_msh(one_cell(3, "1 2 3 4", coordinates, 4), "m.msh", section); });
}

TEST(PlaneMesh, NodesOutsideThePlaneOrBeyondTheAxisAreErrors) {
  const std::string tilted = "1 0 0 0\n2 1 0 0\n3 1 1 0.5\n4 0 1 0.5\n",
                    crossing = "1 -1 0 0\n2 1 0 0\n3 1 1 0\n4 -1 1 0\n";
  EXPECT_TRUE(creepcontact::test::says(error_of({Analysis::plane_stress}, tilted),
                                       {"m.msh", "(1, 1, 0.5)", "z = 0", "plane_stress"}));
  EXPECT_TRUE(creepcontact::test::says(error_of({Analysis::axisymmetric}, crossing),
                                       {"m.msh", "(-1, 0, 0)", "negative radius", "x >= 0"}));
  EXPECT_NO_THROW(read_msh(one_cell(3, "1 2 3 4", crossing, 4), "m.msh", {Analysis::plane_strain}));
}

TEST(PlaneMesh, WithoutAnalysisTheKeyIsNamed) {
  const std::string message = error_of({}, square.substr(0, square.find("5 0.5")));
  EXPECT_TRUE(creepcontact::test::says(message, {"only surface cells", "analysis = \"axisymmetric\"", "plane_strain"}));
}

TEST(PlaneMesh, VolumesAloneAreNoSection) {
  const std::string tetrahedron =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n";
  const std::string message =
      test::message_of<ModelError>([&] { read_msh(tetrahedron, "m.msh", {Analysis::axisymmetric}); });
  EXPECT_TRUE(creepcontact::test::says(message, {"physical surface", "axisymmetric", "leave 'analysis' out"}));
}

TEST(PlaneMesh, GeoIsMeshedInTwoDimensions) {
  const test::TemporaryDirectory directory;
  const std::string geo =
      "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {1, 0, 0, 2, 1};\nTransfinite Curve{1, 2, 3, 4} = 3;\n"
      "Transfinite Surface{1}; Recombine Surface{1};\nPhysical Surface(\"ring\") = {1};\n";
  const auto file = test::write_text(directory / "ring.geo", geo);
  const mesh::Mesh mesh = read_mesh(file, {.order = 2, .section = {Analysis::axisymmetric}});
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(mesh.blocks[0].type, mesh::CellType::quad8);
  EXPECT_EQ(mesh.blocks[0].size(), 4u);
}

TEST(GeoLines, StatementsThatGmshWouldLoseAreAnError) {
  const test::TemporaryDirectory directory;
  const std::string geo = "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {1, 0, 0, 2, 1};\n";
  const std::string last = "Physical Surface(\"ring\") = {1}; Physical Curve(\"out\") = {2};";
  const GmshOptions options{.order = 2, .section = {Analysis::axisymmetric}};
  const auto file = test::write_text(directory / "ring.geo", geo + last);
  const std::string message = test::message_of<ModelError>([&] { read_mesh(file, options); });
  EXPECT_TRUE(creepcontact::test::says(message, {"ring.geo:3", "line end"}));
  const mesh::Mesh mesh = read_mesh(test::write_text(directory / "ended.geo", geo + last + "\n"), options);
  EXPECT_EQ(mesh.groups.size(), 2u);
}

}  // namespace
}  // namespace creepcontact::io
