/// Field files are read as they were written.

#include "creepcontact/io/fields/field_reader.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "creepcontact/base/error.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io::test {
namespace {

/// One cell of every type, each with nodes of its own.
FieldMesh one_of_each() {
  FieldMesh mesh;
  for (const mesh::CellType type : mesh::cell_types()) {
    mesh::CellBlock block{type, {}};
    for (int i = 0; i < mesh::n_nodes(type); ++i) {
      block.connectivity.push_back(std::ssize(mesh.points));
      mesh.points.emplace_back(i, 0.25 * i, -1.0 / (i + 1));
    }
    mesh.blocks.push_back(std::move(block));
  }
  mesh.texts.push_back({"bodies", {"disc", "shaft & hub"}});
  return mesh;
}

TEST(FieldReader, ReadsWhatWasWritten) {
  const TemporaryDirectory directory;
  const FieldMesh mesh = one_of_each();
  FieldWriter writer(directory.path(), "fields", mesh, "mm, N");
  std::vector<double> stress(6 * mesh.points.size()), cells(mesh.n_cells());
  for (std::size_t i = 0; i < stress.size(); ++i) stress[i] = 1.0 / static_cast<double>(1 + i);
  writer.write(0, {{"stress [MPa]", 6, stress}}, {{"body", 1, cells}});
  writer.write(
      2.5, {{"stress [MPa]", 6, stress}, {"s", 3, std::vector<double>(3 * mesh.points.size()), {"r", "t", "z"}}}, {});
  const std::vector<FieldEntry> list = read_field_list(directory.path() / "fields.pvd");
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].time, 2.5);
  const FieldFile file(list[1].file);
  EXPECT_EQ(file.n_points(), mesh.points.size());
  EXPECT_EQ(file.n_cells(), mesh.n_cells());
  const FieldMesh read = file.mesh();
  EXPECT_EQ(read.points, mesh.points);
  ASSERT_EQ(read.blocks.size(), mesh.blocks.size());
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    EXPECT_EQ(read.blocks[b].type, mesh.blocks[b].type);
    EXPECT_EQ(read.blocks[b].connectivity, mesh.blocks[b].connectivity) << mesh::name(mesh.blocks[b].type);
  }
  ASSERT_FALSE(read.texts.empty());
  EXPECT_EQ(read.texts.back().values, mesh.texts.back().values);
  ASSERT_EQ(file.point_arrays().size(), 2U);
  EXPECT_EQ(file.point_arrays()[0].name, "stress [MPa]");
  EXPECT_EQ(file.point_arrays()[0].components, 6);
  EXPECT_EQ(file.point_arrays()[1].component_names, (std::vector<std::string>{"r", "t", "z"}));
  EXPECT_EQ(file.point_values("stress [MPa]"), stress);
  EXPECT_THROW(file.point_values("strain"), ModelError);
}

TEST(FieldReader, RefusesDamagedFiles) {
  const TemporaryDirectory directory;
  FieldWriter writer(directory.path(), "fields", one_of_each(), "");
  const std::filesystem::path path = writer.write(0, {}, {});
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NO_THROW(FieldFile(text, "whole").mesh());
  for (const std::size_t kept : {std::size_t{0}, std::size_t{40}, text.size() / 3, text.size() * 2 / 3})
    EXPECT_THROW(FieldFile(text.substr(0, kept), "cut").mesh(), ModelError) << kept;
  EXPECT_THROW(FieldFile(directory.path() / "none.vtu"), ModelError);
  EXPECT_THROW(parse_field_list("<VTKFile/>", ".", "list"), ConfigError);
  EXPECT_THROW(parse_field_list("text", ".", "list"), ConfigError);
}

}  // namespace
}  // namespace creepcontact::io::test
