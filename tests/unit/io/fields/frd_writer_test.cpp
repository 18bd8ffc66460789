#include "creepcontact/io/fields/frd_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "unit/io/temporary_directory.hpp"
#include "unit/mesh/reference_cells.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;

/// With the numbers 11, 12, ... of nodes, and 7 of the cell.
mesh::Mesh numbered_cell(CellType type) {
  mesh::Mesh mesh;
  mesh.nodes = mesh::test::reference_nodes(type);
  mesh.blocks.push_back({type, {}, {7}});
  for (int i = 0; i < mesh::n_nodes(type); ++i) {
    mesh.blocks[0].connectivity.push_back(i);
    mesh.node_numbers.push_back(11 + i);
  }
  return mesh;
}

class Frd : public testing::Test {
 protected:
  std::string text() const {
    std::ifstream stream(path_);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  test::TemporaryDirectory directory_;
  const std::filesystem::path path_ = directory_ / "fields.frd";
};

TEST_F(Frd, MidsideNodesUprightBeforeTop) {
  const mesh::Mesh hexahedron = numbered_cell(CellType::hex20);
  const FrdWriter writer(path_, {&hexahedron});
  EXPECT_NE(text().find(" -1         7    4    0    1\n"
                        " -2        11        12        13        14        15        16        17        18        19 "
                        "       22\n"
                        " -2        24        20        21        23        25        26        27        29        30 "
                        "       28\n -3\n"),
            std::string::npos)
      << text();
  EXPECT_TRUE(text().ends_with(" -3\n 9999\n"));
}

TEST_F(Frd, SharedNodesHaveTheMeanAndUnknownOnesNoRow) {
  const mesh::Mesh first = numbered_cell(CellType::tet4);
  mesh::Mesh second = first;
  second.node_numbers = {11, 12, 13, 20};
  FrdWriter writer(path_, {&first, &second});
  const double unknown = std::nan("");
  writer.write(0.5, {{"PE", {"PE"}, FrdField::Kind::scalars, {1, 2, 3, unknown, 3, 2, 1e-200, 8}}});
  const std::string expected =
      "    1PSTEP                         1           1           1\n"
      "  100CL  101         0.5           4                     0    1           1\n"
      " -4  PE          1    1\n"
      " -5  PE          1    1    0    0\n"
      " -1        11 2.00000E+00\n -1        12 2.00000E+00\n -1        13 1.50000E+00\n -1        20 8.00000E+00\n"
      " -3\n 9999\n";
  EXPECT_NE(text().find(expected), std::string::npos) << text();
  EXPECT_THROW(writer.write(1, {{"PE", {"PE"}, FrdField::Kind::scalars, {1, 2}}}), std::invalid_argument);
}

TEST_F(Frd, ResumingGoesOnAfterTheLastTime) {
  const mesh::Mesh mesh = numbered_cell(CellType::tet4);
  const std::vector<FrdField> fields{{"DISP", {"D1", "D2", "D3"}, FrdField::Kind::vector, std::vector<double>(12, 2.5)},
                                     {"PE", {"PE"}, FrdField::Kind::scalars, {1, 2, 3, 4}}};
  {
    FrdWriter writer(path_, {&mesh});
    for (const double time : {0.0, 8760.125, 1e5}) writer.write(time, fields);
  }
  const std::string uninterrupted = text();
  {
    FrdWriter writer(path_, {&mesh}, {.resume = true, .last_time = 8760.125});
    EXPECT_LT(text().size(), uninterrupted.size());
    writer.write(1e5, fields);
  }
  EXPECT_EQ(text(), uninterrupted);
  std::ofstream(path_) << uninterrupted.substr(0, uninterrupted.size() - 40);  // cut off within a block
  {
    FrdWriter writer(path_, {&mesh}, {.resume = true, .last_time = 1e5});
    EXPECT_TRUE(text().ends_with(" -3\n 9999\n"));
  }
}

}  // namespace
}  // namespace creepcontact::io
