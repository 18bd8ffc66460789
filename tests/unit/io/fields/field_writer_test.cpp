#include "creepcontact/io/fields/field_writer.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "unit/io/fields/vtu_reader.hpp"
#include "unit/io/temporary_directory.hpp"
#include "unit/mesh/reference_cells.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;
using test::contains;
using test::message_of;
using test::VtuReader;

mesh::Mesh single_cell(CellType type) {
  mesh::Mesh mesh;
  mesh.nodes = mesh::test::reference_nodes(type);
  mesh.blocks.push_back({type, {}});
  for (int i = 0; i < mesh::n_nodes(type); ++i) mesh.blocks[0].connectivity.push_back(i);
  mesh.blocks.push_back({CellType::line2, {0, 1}});
  return mesh;
}

FieldMesh field_mesh(const std::vector<CellType>& types) {
  FieldMesh result;
  for (CellType type : types) result.append(single_cell(type));
  return result;
}

class Fields : public testing::Test {
 protected:
  test::TemporaryDirectory directory_;
};

TEST_F(Fields, ReadBackExactly) {
  FieldWriter writer(directory_.path(), "ring", field_mesh({CellType::hex8, CellType::tet4}), "mm, N");
  const std::vector<double> scalar{0.1, 1.0 / 3, -7, 1e300, 5, 6, 7, 8, 9, 10, 11, std::nan("")};
  std::vector<double> vectors(36), tensors(12);
  for (std::size_t i = 0; i < 36; ++i) vectors[i] = std::sqrt(static_cast<double>(i));
  for (std::size_t i = 0; i < 12; ++i) tensors[i] = std::sin(static_cast<double>(i));
  const auto file = writer.write(0.25, {{"temperature", 1, scalar}, {"displacement", 3, vectors, {"x", "y", "z"}}},
                                 {{"stress", 6, tensors}});
  EXPECT_EQ(file, directory_ / "ring/ring_0000.vtu");

  const VtuReader vtu(file);
  EXPECT_EQ(vtu.piece().attribute("NumberOfPoints").as_int(), 12);
  EXPECT_EQ(vtu.piece().attribute("NumberOfCells").as_int(), 2);
  const auto temperature = vtu.values<double>("PointData", "temperature");
  EXPECT_TRUE(std::isnan(temperature.back()));
  EXPECT_TRUE(std::equal(temperature.begin(), temperature.end() - 1, scalar.begin()));
  EXPECT_EQ(vtu.values<double>("PointData", "displacement"), vectors);
  EXPECT_EQ(vtu.values<double>("CellData", "stress"), tensors);
  EXPECT_STREQ(vtu.array("PointData", "displacement").attribute("ComponentName2").value(), "z");
  EXPECT_EQ(vtu.array("CellData", "stress").attribute("NumberOfComponents").as_int(), 6);
  EXPECT_EQ(vtu.values<std::int64_t>("Cells", "connectivity"),
            (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(vtu.values<std::int64_t>("Cells", "offsets"), (std::vector<std::int64_t>{8, 12}));
  EXPECT_EQ(vtu.values<std::uint8_t>("Cells", "types"), (std::vector<std::uint8_t>{12, 10}));
  EXPECT_EQ(vtu.values<double>("Points", "Points")[6], 1.0);  // x of point 2
  // The bytes of the last array come first: meshio 5 can then not take one array for another (vtu_document.cpp).
  const auto offset = [&](const char* where, const char* name) {
    return vtu.array(where, name).attribute("offset").as_int();
  };
  EXPECT_EQ(offset("Cells", "types"), 0);
  EXPECT_GT(offset("Cells", "connectivity"), offset("Cells", "offsets"));
  EXPECT_GT(offset("CellData", "stress"), offset("Points", "Points"));
  EXPECT_GT(offset("PointData", "temperature"), offset("PointData", "displacement"));
}

TEST_F(Fields, ArraysOfSeveralBlocksReadBack) {
  FieldMesh mesh;
  mesh.points.assign(100000, Vector3(1, 2, 3));  // 2.4 MB
  FieldWriter writer(directory_.path(), "large", mesh, "");
  std::vector<double> values(100000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::cos(static_cast<double>(i));
  const VtuReader vtu(writer.write(0, {{"v", 1, values}}, {}));
  EXPECT_EQ(vtu.values<double>("PointData", "v"), values);
  EXPECT_EQ(vtu.values<double>("Points", "Points").size(), 300000u);
}

TEST_F(Fields, TimeUnitsAndNamesAreFieldData) {
  FieldMesh mesh = field_mesh({CellType::tet4});
  mesh.texts.push_back({"bodies", {"pin", "hub"}});
  FieldWriter writer(directory_.path(), "a", mesh, "mm");
  const VtuReader vtu(writer.write(0.1, {}, {}));
  const pugi::xml_node data = vtu.grid().child("FieldData");
  EXPECT_EQ(data.child("DataArray").text().as_double(), 0.1);
  // Readers other than VTK know no arrays of strings.
  EXPECT_TRUE(data.child("Array").empty());
  for (const pugi::xml_node array : data.children("DataArray"))
    EXPECT_TRUE(test::contains("Float64 Int32", array.attribute("type").as_string()));
  EXPECT_STREQ(data.find_child_by_attribute("DataArray", "Name", "units").attribute("ComponentName0").as_string(),
               "mm");
  const pugi::xml_node bodies = data.find_child_by_attribute("DataArray", "Name", "bodies");
  EXPECT_EQ(bodies.attribute("NumberOfComponents").as_int(), 2);
  EXPECT_STREQ(bodies.attribute("ComponentName0").as_string(), "pin");
  EXPECT_STREQ(bodies.attribute("ComponentName1").as_string(), "hub");
  EXPECT_STREQ(bodies.text().as_string(), "0 1");
}

TEST_F(Fields, NamesHaveNoEndOfATag) {
  FieldMesh mesh = field_mesh({CellType::tet4});
  mesh.texts.push_back({"bodies", {"a > b", "<\"c\" & 'd'>"}});
  FieldWriter writer(directory_.path(), "a", mesh, "N>, mm");
  const std::filesystem::path file = writer.write(0, {}, {});
  const VtuReader vtu(file);
  const pugi::xml_node data = vtu.grid().child("FieldData");
  const pugi::xml_node bodies = data.find_child_by_attribute("DataArray", "Name", "bodies");
  EXPECT_STREQ(bodies.attribute("ComponentName0").as_string(), "a > b");
  EXPECT_STREQ(bodies.attribute("ComponentName1").as_string(), "<\"c\" & 'd'>");
  // VTK takes any ">" for the end of a tag.
  const std::string text = test::read_text(file);
  bool in_value = false;
  for (const char c : text.substr(0, text.find("<AppendedData"))) {
    if (c == '"') in_value = !in_value;
    EXPECT_FALSE(in_value && c == '>');
  }
}

TEST_F(Fields, CollectionListsEveryTimeWritten) {
  FieldWriter writer(directory_.path(), "a", field_mesh({CellType::tet4}), "");
  writer.write(0, {}, {});
  writer.write(1.0 / 3, {}, {});
  pugi::xml_document pvd;
  ASSERT_TRUE(pvd.load_file((directory_ / "a.pvd").c_str()));
  std::vector<std::pair<double, std::string>> entries;
  for (const auto& node : pvd.child("VTKFile").child("Collection").children("DataSet"))
    entries.emplace_back(node.attribute("timestep").as_double(), node.attribute("file").as_string());
  EXPECT_EQ(entries, (std::vector<std::pair<double, std::string>>{{0, "a/a_0000.vtu"}, {1.0 / 3, "a/a_0001.vtu"}}));
}

TEST_F(Fields, ResumingKeepsEntriesUpToTheCheckpoint) {
  const FieldMesh mesh = field_mesh({CellType::tet4});
  {
    FieldWriter writer(directory_.path(), "a", mesh, "");
    for (double t : {0.0, 1.0, 2.0, 3.0}) writer.write(t, {}, {});
  }
  FieldWriter writer(directory_.path(), "a", mesh, "", {true, 1.5});
  EXPECT_EQ(writer.write(1.75, {}, {}), directory_ / "a/a_0002.vtu");
  const std::string text = test::read_text(directory_ / "a.pvd");
  EXPECT_TRUE(contains(text, "timestep=\"1\"") && contains(text, "timestep=\"1.75\""));
  EXPECT_FALSE(contains(text, "timestep=\"2\"") || contains(text, "a_0003"));
  test::write_text(directory_ / "a.pvd", "<VTKFile><Coll");
  EXPECT_TRUE(test::says(message_of<ConfigError>([&] {
                           FieldWriter(directory_.path(), "a", mesh, "", {true, 1});
                         }),
                         {"a.pvd'", "list"}));
}

TEST_F(Fields, ArraysOfTheWrongSizeAreErrors) {
  FieldWriter writer(directory_.path(), "a", field_mesh({CellType::tet4}), "");
  EXPECT_THROW(writer.write(0, {{"v", 1, {1, 2, 3}}}, {}), std::invalid_argument);
  EXPECT_THROW(writer.write(0, {{"v", 2, std::vector<double>(8)}}, {}), std::invalid_argument);
  EXPECT_THROW(writer.write(0, {}, {{"v", 3, {1, 2}}}), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "a.pvd"));
}

// Corners between which VTK's mid-edge nodes lie, in VTK's order (headers of vtkQuadraticTetra, vtkQuadraticHexahedron,
// vtkQuadraticWedge), and the faces of vtkTriQuadraticHexahedron by their outward direction.
using Pairs = std::vector<std::array<std::size_t, 2>>;
const std::map<CellType, Pairs> vtk_edges{
    {CellType::tet10, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
    {CellType::hex20, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
    {CellType::hex27, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
    {CellType::wedge15, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}}};

class VtkOrder : public testing::TestWithParam<CellType> {
 protected:
  // Points of the one cell as VTK sees them.
  std::vector<Vector3> cell() {
    FieldWriter writer(directory_.path(), "cell", field_mesh({GetParam()}), "");
    const VtuReader vtu(writer.write(0, {}, {}));
    const auto points = vtu.values<double>("Points", "Points");
    std::vector<Vector3> result;
    for (std::int64_t node : vtu.values<std::int64_t>("Cells", "connectivity"))
      result.emplace_back(Vector3(&points[3 * node]));
    return result;
  }
  test::TemporaryDirectory directory_;
};

// vtkWedge: "(0,1,2) is the base of the wedge which, using the right hand rule, forms a triangle whose normal points
// outward". The corners of the other cells are those of Gmsh.
TEST_P(VtkOrder, CornersAreOrientedAsVtkWantsThem) {
  const auto vtk = cell();
  const int corners = mesh::n_corners(GetParam());
  if (corners == 6) {
    EXPECT_LT((vtk[1] - vtk[0]).cross(vtk[2] - vtk[0]).dot(vtk[3] - vtk[0]), 0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(vtk[i] + Vector3(0, 0, 2), vtk[i + 3]);
    return;
  }
  const auto gmsh = mesh::test::reference_nodes(GetParam());
  ASSERT_EQ(vtk.size(), gmsh.size());
  for (std::size_t i = 0; i < static_cast<std::size_t>(corners); ++i) EXPECT_EQ(vtk[i], gmsh[i]);
}

TEST_P(VtkOrder, MidNodesLieWhereVtkExpectsThem) {
  const auto found = vtk_edges.find(GetParam());
  if (found == vtk_edges.end()) {
    EXPECT_EQ(mesh::order(GetParam()), 1);
    return;
  }
  const auto vtk = cell();
  const std::size_t corners = mesh::n_corners(GetParam());
  for (std::size_t e = 0; e < found->second.size(); ++e) {
    const auto [a, b] = found->second[e];
    EXPECT_EQ(vtk[corners + e], Vector3(0.5 * (vtk[a] + vtk[b]))) << "edge " << e;
  }
  if (GetParam() != CellType::hex27) return;
  const std::vector<Vector3> faces{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 0, 0}};
  for (std::size_t f = 0; f < faces.size(); ++f) EXPECT_EQ(vtk[20 + f], faces[f]) << "face " << f;
}

INSTANTIATE_TEST_SUITE_P(Cells, VtkOrder, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& type) { return std::string(mesh::name(type.param)); });

/// Replaced as a whole, it would make the file system wait for the disk at every output time.
TEST_F(Fields, TheListGrowsInPlace) {
  FieldWriter writer(directory_.path(), "ring", field_mesh({CellType::tet4}), "");
  const auto list = directory_ / "ring.pvd";
  const std::vector<double> values(4, 1.0);
  writer.write(0, {{"a", 1, values}}, {});
  std::filesystem::create_hard_link(list, directory_ / "same");
  writer.write(0.5, {{"a", 1, values}}, {});
  EXPECT_EQ(test::read_text(directory_ / "same"), test::read_text(list));
  EXPECT_TRUE(contains(test::read_text(list), "timestep=\"0.5\""));
  EXPECT_TRUE(test::read_text(list).ends_with("</VTKFile>\n"));
  std::filesystem::remove(list);  // a user who tidies up
  writer.write(1, {{"a", 1, values}}, {});
  EXPECT_TRUE(contains(test::read_text(list), "timestep=\"0.5\""));
  EXPECT_EQ(writer.take_unsynced().size(), 4U);
  EXPECT_TRUE(writer.take_unsynced().empty());
}

}  // namespace
}  // namespace creepcontact::io
