/// The solid that pictures show of an axisymmetric section.
#include "../../../src/results/revolved_section.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "creepcontact/mechanics/discretization.hpp"
#include "support/mechanics/sections.hpp"

namespace creepcontact::results {
namespace {

using mesh::CellType;

io::FieldMesh section(CellType type) {
  io::FieldMesh result;
  result.append(creepcontact::test::section_mesh(type, {2, 3}, {1, 2}, {1, 0}, {settings::Analysis::axisymmetric}));
  return result;
}

TEST(RevolvedSection, CellsFillTheRing) {
  for (const CellType type : {CellType::tri3, CellType::tri6, CellType::quad4, CellType::quad8, CellType::quad9}) {
    const io::FieldMesh solid = RevolvedSection(section(type), 48).mesh();
    mesh::Mesh mesh;
    mesh.nodes = solid.points;
    mesh.blocks = solid.blocks;
    const mechanics::Discretization solids(mesh);  // throws if one is inverted
    double volume = 0;
    for (const double weight : solids.weights()) volume += weight;
    const double exact = std::numbers::pi * (4 - 1) * 2;
    EXPECT_NEAR(volume / exact, 1, mesh::order(type) == 1 ? 4e-3 : 1e-5) << mesh::name(type);
  }
}

TEST(RevolvedSection, VectorsAndTensorsTurn) {
  const io::FieldMesh flat = section(CellType::quad4);
  const std::size_t n = flat.points.size();
  io::FieldData displacement{"displacement", 3, {}}, stress{"stress", 6, {}},
      principal{"principal", 3, {}, {"1", "2", "3"}};
  for (std::size_t i = 0; i < n; ++i) {
    displacement.values.insert(displacement.values.end(), {1, 2, 0});
    stress.values.insert(stress.values.end(), {10, 20, 30, 5, 0, 0});
    principal.values.insert(principal.values.end(), {3, 2, 1});
  }
  const RevolvedSection ring(flat, 4);
  const auto turned = ring.at_points({displacement, stress, principal});
  // Layers are an eighth of the circle apart: the second quarter lies along z.
  const std::size_t along_z = 2 * n;
  EXPECT_NEAR((ring.mesh().points[along_z] - Vector3(0, flat.points[0].y(), flat.points[0].x())).norm(), 0, 1e-12);
  const std::vector<double> expected_vector{0, 2, 1}, expected_tensor{30, 20, 10, 0, 5, 0}, kept{3, 2, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(turned[0].values[3 * along_z + k], expected_vector[k], 1e-12);
    EXPECT_EQ(turned[2].values[3 * along_z + k], kept[k]);
  }
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(turned[1].values[6 * along_z + k], expected_tensor[k], 1e-12);
  EXPECT_EQ(ring.at_cells({{"body", 1, std::vector<double>(flat.n_cells(), 2.0)}})[0].values.size(),
            4 * flat.n_cells());
}

}  // namespace
}  // namespace creepcontact::results
