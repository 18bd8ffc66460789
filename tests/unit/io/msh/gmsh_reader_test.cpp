#include "creepcontact/io/msh/gmsh_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "creepcontact/mesh/cell_faces.hpp"
#include "support/says.hpp"
#include "unit/io/msh/cube.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;
using mesh::Mesh;
using test::message_of;
using test::says;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool address_sanitizer = true;
#else
constexpr bool address_sanitizer = false;
#endif

class GmshReader : public testing::Test {
 protected:
  std::filesystem::path geo(const std::string& text) { return test::write_text(directory_ / "model.geo", text); }
  Mesh cube(const std::string& cells, const GmshOptions& options) {
    return read_mesh(geo(test::cube_geo(cells)), options);
  }
  test::TemporaryDirectory directory_;
};

const mesh::CellBlock& volume_block(const Mesh& mesh) {
  return mesh.blocks.at(mesh.group("cube", 3).cells.at(0).block);
}

Vector3 at(const Mesh& mesh, std::int64_t node) {
  return mesh.nodes.at(node);
}

// Sum of the area vectors of a group's outward faces, exact for plane faces with straight edges.
Vector3 area(const Mesh& mesh, const std::string& surface) {
  Vector3 sum = Vector3::Zero();
  for (const mesh::Face& face : mesh::boundary_faces(mesh, surface)) {
    const auto& n = face.nodes;
    const bool triangle = mesh::n_corners(face.type) == 3;
    const Vector3 first = at(mesh, n[triangle ? 1 : 2]) - at(mesh, n[0]);
    const Vector3 second = triangle ? at(mesh, n[2]) - at(mesh, n[0]) : at(mesh, n[3]) - at(mesh, n[1]);
    sum += 0.5 * first.cross(second);
  }
  return sum;
}

struct Kind {
  const char* cells;
  int order;
  CellType type;
};

class GmshCube : public GmshReader, public testing::WithParamInterface<Kind> {};

TEST_P(GmshCube, HasItsCellsGroupsAndOutwardFaces) {
  const auto [cells, order, type] = GetParam();
  const Mesh mesh = cube(cells, {order, {}});
  EXPECT_EQ(volume_block(mesh).type, type);
  EXPECT_LT((area(mesh, "bottom") - Vector3(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((area(mesh, "top") - Vector3(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT(area(mesh, "sides").norm(), 1e-12);
  EXPECT_EQ(mesh::group_nodes(mesh, "edge").size(), order == 1 ? 3u : 5u);
  EXPECT_EQ(at(mesh, mesh::group_nodes(mesh, "corner").at(0)), Vector3(0, 0, 0));
  EXPECT_EQ(mesh.group("77", 2).cells.size(), mesh.group("bottom", 2).cells.size());
}

TEST_P(GmshCube, MidNodesFollowTheEdgeTable) {
  const Mesh mesh = cube(GetParam().cells, {GetParam().order, {}});
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (mesh::order(block.type) == 1) continue;
    const auto& edges = mesh::cell_edges(block.type);
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [a, b] = edges[e];
        const Vector3 middle = 0.5 * (at(mesh, cell[a]) + at(mesh, cell[b]));
        EXPECT_LT((at(mesh, cell[mesh::n_corners(block.type) + e]) - middle).norm(), 1e-9)
            << mesh::name(block.type) << " edge " << e;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, GmshCube,
                         testing::Values(Kind{"hex", 1, CellType::hex8}, Kind{"hex", 2, CellType::hex20},
                                         Kind{"wedge", 1, CellType::wedge6}, Kind{"wedge", 2, CellType::wedge15},
                                         Kind{"tet", 1, CellType::tet4}, Kind{"tet", 2, CellType::tet10}),
                         [](const auto& kind) { return std::string(mesh::name(kind.param.type)); });

TEST_F(GmshReader, CountsOfTheTransfiniteCube) {
  const Mesh linear = cube("hex", {1, {}});
  EXPECT_EQ(linear.nodes.size(), 27u);
  EXPECT_EQ(volume_block(linear).size(), 8u);
  EXPECT_EQ(cube("hex", {2, {}}).nodes.size(), 81u);
}

TEST_F(GmshReader, ParametersOverridePlainAndNamedConstants) {
  const Mesh mesh = cube("hex", {1, {{"n", 3}, {"height", 2.5}}});
  EXPECT_EQ(volume_block(mesh).size(), 27u);
  double top = 0;
  for (const Vector3& node : mesh.nodes) top = std::max(top, node[2]);
  EXPECT_EQ(top, 2.5);
}

TEST_F(GmshReader, ParametersDoNotLeakIntoTheNextMesh) {
  EXPECT_EQ(volume_block(cube("hex", {1, {{"n", 3}}})).size(), 27u);
  EXPECT_EQ(volume_block(cube("hex", {1, {}})).size(), 8u);
}

TEST_F(GmshReader, ParametersReachIncludedFiles) {
  test::write_text(directory_ / "sizes.geo",
                   "// DefineConstant[ commented = 1 ];\nDefineConstant[ wide = 2, text = \"a\" ];");
  const auto file =
      geo("Include \"sizes.geo\";\nSetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, wide, 1, 1};\n"
          "Physical Volume(\"cube\") = {1};");
  double right = 0;
  for (const Vector3& node : read_mesh(file, {1, {{"wide", 7}}}).nodes) right = std::max(right, node[0]);
  EXPECT_NEAR(right, 7, 1e-12);
  EXPECT_TRUE(says(message_of<ConfigError>([&] {
                     read_mesh(file, {1, {{"width", 7}}});
                   }),
                   {"model.geo: ", "'width'", "wide"}));
  for (const char* other : {"commented", "text"})
    EXPECT_THROW(read_mesh(file, {1, {{other, 7}}}), ConfigError) << other;
}

TEST_F(GmshReader, TheSameFileGivesTheSameMesh) {
  const Mesh first = cube("tet", {2, {}}), second = cube("tet", {2, {}});
  EXPECT_EQ(first.nodes, second.nodes);
  ASSERT_EQ(first.blocks.size(), second.blocks.size());
  for (std::size_t b = 0; b < first.blocks.size(); ++b)
    EXPECT_EQ(first.blocks[b].connectivity, second.blocks[b].connectivity);
}

TEST_F(GmshReader, MshFilesOfAllFormatsGiveTheMeshOfTheGeo) {
  const std::string text = test::cube_geo("wedge") + "Physical Volume(\"again\") = {out[1]};\n";
  const Mesh expected = read_mesh(geo(text), {2, {}});
  for (const char* version : {"2.2", "4.1"}) {
    for (const char* binary : {"0", "1"}) {
      const auto file = directory_ / "cube.msh";
      const std::string writes =
          fmt::format("Mesh.MshFileVersion = {};\nMesh.Binary = {};\nMesh 3;\nSave \"cube.msh\";\n", version, binary);
      read_mesh(geo(text + writes), {.order = 2, .trusted = true});

      const Mesh mesh = read_mesh(file);
      ASSERT_EQ(mesh.nodes.size(), expected.nodes.size()) << version << binary;
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i) EXPECT_LT((mesh.nodes[i] - expected.nodes[i]).norm(), 1e-14);
      ASSERT_EQ(mesh.blocks.size(), expected.blocks.size());
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
        EXPECT_EQ(mesh.blocks[b].size(), expected.blocks[b].size()) << version << binary;
      ASSERT_EQ(mesh.groups.size(), expected.groups.size());
      for (const auto& [name, group] : expected.groups) {
        EXPECT_EQ(mesh.group(name, group.dimension).cells.size(), group.cells.size()) << name;
        EXPECT_EQ(mesh::group_nodes(mesh, name), mesh::group_nodes(expected, name)) << name;
      }
    }
  }
}

TEST_F(GmshReader, NodesOutsideTheGroupsAreDropped) {
  const auto file =
      geo("SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nBox(2) = {5, 0, 0, 1, 1, 1};\n"
          "Physical Volume(\"cube\") = {1};");
  const Mesh mesh = read_mesh(file);
  EXPECT_FALSE(mesh.nodes.empty());
  for (const Vector3& node : mesh.nodes) EXPECT_LT(node[0], 1.1);
}

TEST_F(GmshReader, UnsupportedCellsAreNamedWithTheirGroup) {
  const auto file =
      test::write_text(directory_ / "pyramid.msh",
                       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                       "4 0 1 0\n5 0.5 0.5 1\n$EndNodes\n$Elements\n1\n1 7 2 12 1 1 2 3 4 5\n$EndElements\n");
  const std::string message = message_of<ModelError>([&] { read_mesh(file); });
  EXPECT_TRUE(says(message, {"pyramid.msh: ", "'12'", "'Pyramid 5'"}));
}

TEST_F(GmshReader, NamesMustDifferBetweenDimensions) {
  const auto file =
      geo("SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nPhysical Volume(\"a\") = {1};\n"
          "Physical Surface(\"a\") = {1};");
  EXPECT_TRUE(says(message_of<ModelError>([&] { read_mesh(file); }), {"model.geo: ", "surface", "volume", "'a'"}));
}

TEST_F(GmshReader, GmshErrorsAreTold) {
  const std::string message = message_of<ModelError>([&] { read_mesh(geo("h = 1;\nPoint(1) = {0, 0 0};\n")); });
  EXPECT_TRUE(says(message, {"model.geo: Gmsh", "line 2: syntax error"}));
}

TEST_F(GmshReader, StatementsThatReachOutAreRefusedWithTheirLines) {
  for (const char* statement :
       {"SystemCall \"touch made\";", "NonBlockingSystemCall \"touch made\";", "Exit;", "Abort;", "Save \"made\";",
        "Print Sprintf(\"made\");", "Printf(\"a (%g)\", Sin(1)) > \"made\";", "Printf('a') >> 'made';",
        "CreateDir \"made\";", "OnelabRun(\"a\", \"touch made\");"}) {
    const std::string word = std::string(statement).substr(0, std::string(statement).find_first_of(" (;"));
    const auto file = geo("/* Exit;\n */ Save = 1;\n" + std::string(statement) + "\n" + test::cube_geo("hex"));
    const std::string message = message_of<ModelError>([&] { read_mesh(file); });
    EXPECT_TRUE(says(message, {"model.geo:3: '" + word + "'", "--trust-geometry"}));
    test::write_text(directory_ / "part.geo", statement);
    EXPECT_TRUE(says(message_of<ModelError>([&] { read_mesh(geo("Include \"part.geo\";\n")); }), {"part.geo:1: "}));
  }
  EXPECT_FALSE(std::filesystem::exists(directory_ / "made"));
}

// Names that are computed escape the scan, but not the confinement.
TEST_F(GmshReader, HiddenStatementsAreStopped) {
  for (const char* statement : {"SystemCall \"touch made\";", "Save \"made.msh\";", "CreateDir \"made\";"}) {
    test::write_text(directory_ / "part.geo", std::string("\n") + statement + "\n");
    const auto file = geo(test::cube_geo("hex") + "Include Sprintf(\"part.geo\");\n");
    const std::string message = message_of<ModelError>([&] { read_mesh(file); });
    EXPECT_TRUE(says(message, {"model.geo: ", "tried", "--trust-geometry"}));
  }
  EXPECT_FALSE(std::filesystem::exists(directory_ / "made"));
  EXPECT_FALSE(std::filesystem::exists(directory_ / "made.msh"));
}

TEST_F(GmshReader, TrustedFilesMayRunProgramsAndWriteFiles) {
  const std::string made = (directory_ / "made").string();
  const auto file =
      geo("SystemCall \"touch " + made + "\";\nPrintf(\"a\") > \"" + made + "2\";\n" + test::cube_geo("hex"));
  EXPECT_EQ(volume_block(read_mesh(file, {.trusted = true})).size(), 8u);
  EXPECT_TRUE(std::filesystem::exists(made));
  EXPECT_TRUE(std::filesystem::exists(made + "2"));
}

TEST_F(GmshReader, OptionFilesAreNotRead) {
  const std::string options = "SystemCall \"touch " + (directory_ / "made").string() + "\";\nn = 5;\n";
  test::write_text(directory_ / "model.geo.opt", options);
  test::write_text(directory_ / "cube.msh.opt", options);
  const std::string save = "Mesh 3;\nSave \"cube.msh\";\n";
  read_mesh(geo(test::cube_geo("hex") + save), {.trusted = true});
  read_mesh(directory_ / "cube.msh");
  EXPECT_FALSE(std::filesystem::exists(directory_ / "made"));
}

TEST_F(GmshReader, WhatEndsGmshIsAnErrorThatTellsWhere) {
  test::write_text(directory_ / "part.geo", "\nExit;\n");
  const std::string exit = message_of<ModelError>([&] { read_mesh(geo("Include Sprintf(\"part.geo\");\n")); });
  EXPECT_TRUE(says(exit, {"model.geo: ", "Exit", "part.geo, line 2"}));
  const std::string loop =
      message_of<ModelError>([&] { read_mesh(geo("For i In {1 : 2}\n  i = 1;\nEndFor\n"), {.time_limit = 0.5}); });
  EXPECT_TRUE(says(loop, {"model.geo: ", "mesh.time_limit = 0.5 s"}));
  const auto itself = geo("Include \"model.geo\";\n");
  EXPECT_NE(message_of<ModelError>([&] { read_mesh(itself); }), "nothing was thrown");
}

TEST_F(GmshReader, MoreMemoryThanAllowedIsAnError) {
  if (address_sanitizer) GTEST_SKIP() << "the sanitizer itself takes more than any bound";
  const auto file = geo("a[] = {1:1e9};\n" + test::cube_geo("hex"));
  const std::string message = message_of<ModelError>([&] { read_mesh(file, {.memory_limit_mb = 50}); });
  EXPECT_TRUE(says(message, {"model.geo: ", "mesh.memory_limit_mb = 50"}));
}

TEST_F(GmshReader, AFileCannotHideItsErrors) {
  for (const char* quiet : {"General.Terminal = 0;\n", "General.Verbosity = 0;\n"}) {
    const auto file = geo(quiet + test::cube_geo("hex") + "Point(77) = {0, 0 0};\n");
    const std::string message = message_of<ModelError>([&] { read_mesh(file); });
    EXPECT_TRUE(says(message, {"syntax error"}) || says(message, {"General.Verbosity"})) << message;
  }
}

TEST_F(GmshReader, FilesThatAreNoMeshAreErrors) {
  EXPECT_TRUE(
      says(message_of<ModelError>([&] { read_mesh(directory_ / "none.msh"); }), {"none.msh: ", "No such file"}));
  EXPECT_TRUE(says(message_of<ModelError>([&] { read_mesh("mesh.inp"); }), {"mesh.inp: ", "readers of their own"}));
  EXPECT_TRUE(says(message_of<ModelError>([&] { read_mesh("mesh.stl"); }), {"mesh.stl: ", ".med", ".unv"}));
  EXPECT_TRUE(says(message_of<ModelError>([&] { read_mesh("mesh.step"); }), {"mesh.step: ", "readers of their own"}));
  EXPECT_THROW(
      read_mesh(test::write_text(directory_ / "broken.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 5")),
      ModelError);
  const std::string no_body = message_of<ModelError>([&] { read_mesh(geo("h = 1;\nPoint(1) = {0, 0, 0};\n")); });
  EXPECT_TRUE(says(no_body, {"model.geo: ", "no physical volume"}));
}

TEST_F(GmshReader, OptionsThatDoNotFitAreErrors) {
  EXPECT_TRUE(says(message_of<ConfigError>([&] { cube("hex", {3, {}}); }), {"order", "3", "1 or 2"}));
  const auto msh = test::write_text(directory_ / "a.msh", "");
  EXPECT_TRUE(says(message_of<ConfigError>([&] { read_mesh(msh, {1, {{"n", 2}}}); }), {"a.msh: ", ".geo"}));
}

}  // namespace
}  // namespace creepcontact::io
