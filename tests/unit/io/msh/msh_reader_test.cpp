#include "../../../../src/io/msh/msh_reader.hpp"

#include <gtest/gtest.h>

#include "creepcontact/base/log.hpp"
#include "support/says.hpp"
#include "unit/io/msh/msh_files.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;
using mesh::Mesh;
using test::says;

std::string error_of(const std::string& bytes) {
  return test::message_of<ModelError>([&] { read_msh(bytes, "m.msh"); });
}

void expect_two_tetrahedra(const Mesh& mesh) {
  ASSERT_EQ(mesh.nodes.size(), 5u);
  EXPECT_EQ(mesh.nodes[0], Vector3(0, 0, 0));
  EXPECT_EQ(mesh.nodes[4], Vector3(1, 1, 1.5));
  ASSERT_EQ(mesh.groups.size(), 3u);
  EXPECT_EQ(mesh.group("body", 3).cells.size(), 2u);
  EXPECT_EQ(mesh.group("also here", 3).cells.size(), 1u);
  EXPECT_EQ(mesh.group("5", 2).cells.size(), 1u);
  EXPECT_EQ(mesh::group_nodes(mesh, "also here"), (std::vector<std::int64_t>{1, 2, 3, 4}));
  EXPECT_EQ(mesh::group_nodes(mesh, "5"), (std::vector<std::int64_t>{0, 1, 2}));
  ASSERT_EQ(mesh.blocks.size(), 2u);
  EXPECT_EQ(mesh.blocks[1].type, CellType::tet4);
  EXPECT_EQ(mesh.blocks[1].connectivity, (std::vector<std::int64_t>{0, 1, 2, 3, 1, 2, 3, 4}));
}

TEST(MshReader, Format22InAscii) {
  expect_two_tetrahedra(read_msh(test::ascii_22, "m.msh"));
}

TEST(MshReader, Format41InAscii) {
  expect_two_tetrahedra(read_msh(test::ascii_41, "m.msh"));
}

TEST(MshReader, BinaryOfBothFormatsAndByteOrders) {
  for (bool swapped : {false, true}) {
    expect_two_tetrahedra(read_msh(test::binary_22(swapped), "m.msh"));
    expect_two_tetrahedra(read_msh(test::binary_41(swapped), "m.msh"));
  }
}

TEST(MshReader, LineEndsOfWindowsAndTheMarkOfUtf8) {
  std::string text = "\xEF\xBB\xBF";
  for (char c : test::ascii_41) text += c == '\n' ? "\r\n" : std::string(1, c);
  expect_two_tetrahedra(read_msh(text, "m.msh"));
}

TEST(MshReader, WhatTheWriterWritesIsReadBack) {
  const MshContent content = read_msh_content(test::ascii_41, "m.msh");
  const MshContent again = read_msh_content(write_msh(content), "m.msh");
  EXPECT_EQ(again.physical_names, content.physical_names);
  EXPECT_EQ(again.physicals.at({3, 2}), content.physicals.at({3, 2}));
  EXPECT_EQ(again.node_tags, content.node_tags);
  EXPECT_EQ(again.nodes, content.nodes);
  ASSERT_EQ(again.elements.size(), content.elements.size());
  for (std::size_t i = 0; i < again.elements.size(); ++i) {
    EXPECT_EQ(again.elements[i].tags, content.elements[i].tags);
    EXPECT_EQ(again.elements[i].nodes, content.elements[i].nodes);
  }
  expect_two_tetrahedra(read_msh(write_msh(content), "m.msh"));
}

TEST(MshReader, NamesThatTheFormatCannotHoldAreNotWritten) {
  MshContent content = read_msh_content(test::ascii_41, "m.msh");
  content.physical_names[{3, 1}] = "a \"b\"";
  EXPECT_THROW(write_msh(content), ModelError);
}

// Whatever the bytes: a mesh or a ModelError that names the file.
void expect_mesh_or_error(const std::string& bytes) {
  try {
    const Mesh mesh = read_msh(bytes, "m.msh");
    EXPECT_GT(mesh.nodes.size(), 0u);
  } catch (const ModelError& error) {
    EXPECT_EQ(std::string(error.what()).find("m.msh"), 0u) << error.what();
  }
}

TEST(MshReader, FilesCutAnywhereAreErrors) {
  for (const std::string& whole : {test::ascii_22, test::ascii_41, test::binary_22(false), test::binary_41(false)}) {
    const std::size_t needed = whole.rfind("$EndElements");
    for (std::size_t size = 0; size < needed; ++size)
      EXPECT_THROW(read_msh(whole.substr(0, size), "m.msh"), ModelError) << size;
  }
}

TEST(MshReader, DamagedBytesAreErrorsOrAnotherMesh) {
  log::set_level(log::Level::error);
  for (const std::string& whole : {test::ascii_22, test::ascii_41, test::binary_22(false), test::binary_41(true)}) {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (int change : {0x01, 0x10, 0x80, 0xFF}) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ change);
        expect_mesh_or_error(damaged);
      }
    }
  }
  log::set_level(log::Level::info);
}

TEST(MshReader, CountsBeyondTheFileTakeNoMemory) {
  const std::string begin = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  EXPECT_TRUE(says(error_of(begin + "$Nodes\n1 18446744073709551615 1 1\n3 1 0 18446744073709551615\n"),
                   {"m.msh, line ", "in $Nodes: ", "18446744073709551615 nodes"}));
  EXPECT_TRUE(says(error_of("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2147483647\n1 0 0 0\n"),
                   {"m.msh, line 5, in $Nodes: ", "2147483647 nodes"}));
  EXPECT_TRUE(
      says(error_of(begin + "$Elements\n1 9 1 9\n3 1 4 99999999999\n"), {"m.msh, line ", "99999999999 elements"}));
}

TEST(MshReader, MessagesSayWhereAndWhat) {
  EXPECT_TRUE(says(error_of(test::replaced(test::ascii_41, "77 0 0\n2 7 1", "77 O 0\n2 7 1")),
                   {"m.msh, line 20, in $Nodes: ", "coordinate", "'O'"}));
  EXPECT_TRUE(says(error_of(test::replaced(test::ascii_22, "3 0 1 0\n", "3 0 nan 0\n")),
                   {"m.msh, line ", "coordinate", "nan"}));
  EXPECT_TRUE(says(error_of(test::binary_41(false).substr(0, 400)), {"m.msh, byte "}));
  EXPECT_TRUE(says(error_of(test::replaced(test::ascii_22, "7 2 3 4 9\n", "7 2 3 4 8\n")),
                   {"m.msh: ", "element 30", "node 8"}));
  EXPECT_TRUE(says(error_of(test::replaced(test::ascii_22, "$EndNodes\n", "7 0 0 0\n$EndNodes\n")),
                   {"m.msh, line ", "$EndNodes"}));
  EXPECT_TRUE(says(error_of(test::ascii_22 + "$Nodes\n0\n$EndNodes\n"), {"m.msh, line ", "twice"}));
  EXPECT_TRUE(says(error_of(test::ascii_22 + "$NodeData\n1\n"), {"m.msh, line ", "$EndNodeData"}));
}

TEST(MshReader, OtherFormatsAreRefusedWithTheWayToConvertThem) {
  for (const char* version : {"1.0", "2.1", "4.0", "3.0"}) {
    const std::string message = error_of(test::replaced(test::ascii_41, "4.1 0 8", std::string(version) + " 0 8"));
    EXPECT_TRUE(
        says(message, {"m.msh: ", std::string("format ") + version, "gmsh OLD.msh -save -format msh41 -o NEW.msh"}));
  }
  EXPECT_TRUE(says(error_of("$NOD\n1\n1 0 0 0\n$ENDNOD\n"), {"m.msh: ", "format 1.0"}));
  EXPECT_TRUE(says(error_of("SystemCall \"true\";\n" + test::ascii_41), {"m.msh: ", "$MeshFormat", "-format msh41"}));
  EXPECT_TRUE(says(error_of(""), {"m.msh: ", "$MeshFormat", "-format msh41"}));
}

TEST(MshReader, ANodeWithTwoPlacesIsAnError) {
  const std::string twice = test::replaced(test::ascii_22, "$Nodes\n6\n", "$Nodes\n7\n3 0 1 0\n");
  expect_two_tetrahedra(read_msh(twice, "m.msh"));
  EXPECT_TRUE(says(error_of(test::replaced(twice, "3 0 1 0\n", "3 0 2 0\n")), {"m.msh: ", "node 3", "twice"}));
}

TEST(MshReader, MeshesWithoutBodiesSayWhatTheyLack) {
  const std::string surfaces = test::replaced(test::ascii_22, "5\n10 2 2 5 7 1 2 3\n", "1\n10 2 2 5 7 1 2 3\n");
  const std::size_t begin = surfaces.find("20 4 3"), end = surfaces.find("$EndElements");
  EXPECT_TRUE(says(error_of(surfaces.substr(0, begin) + surfaces.substr(end)),
                   {"m.msh: ", "surface cells", "\"axisymmetric\""}));
  const std::string unnamed = test::replaced(test::ascii_41, "0 0 0 0 0 0 2 1 2 0", "0 0 0 0 0 0 0 0");
  EXPECT_TRUE(says(error_of(test::replaced(unnamed, "0 0 0 0 0 0 1 -1 0", "0 0 0 0 0 0 0 0")),
                   {"m.msh: ", "no physical volume", "bodies by `Physical Volume("}));
}

TEST(MshReader, PyramidsSayWhereTheyComeFrom) {
  const std::string text = test::replaced(test::ascii_22, "20 4 3 1 7 0 1 2 3 4\n", "20 7 3 1 7 0 1 2 3 4 9\n");
  const std::string message = error_of(text);
  EXPECT_TRUE(says(message, {"m.msh: ", "'body'", "'Pyramid 5'", "hexahedra"}));
}

}  // namespace
}  // namespace creepcontact::io
