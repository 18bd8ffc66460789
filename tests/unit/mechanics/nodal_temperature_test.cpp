/// Temperatures at the nodes of a mesh: its elements interpolate between them.
#include <gtest/gtest.h>

#include <algorithm>

#include "creepcontact/mechanics/body.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace nodal_temperature_tests {
namespace {

using mechanics::Body;
using mechanics::Discretization;
using mechanics::ScatteredTemperatures;
using mechanics::TemperatureField;

constexpr double tolerance = 1e-6;

/// Values of f at the nodes of the mesh, to six digits of place, without those from `left_out` on of each cell.
template <typename F>
TemperatureField nodal(const mesh::Mesh& mesh, const F& f, bool corners_only = false) {
  std::vector<char> wanted(mesh.nodes.size(), 0);
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    const auto n = static_cast<std::size_t>(corners_only ? mesh::n_corners(block.type) : mesh::n_nodes(block.type));
    for (std::size_t c = 0; c < block.size(); ++c)
      for (std::size_t i = 0; i < n; ++i) wanted[block.cell(c)[i]] = 1;
  }
  ScatteredTemperatures given{{}, {0}, {{}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == 0) continue;
    given.points.push_back(mesh.nodes[i] + Vector3::Constant(1e-8));
    given.values[0].push_back(f(mesh.nodes[i]));
  }
  given.node_tolerance = tolerance;
  return TemperatureField(std::move(given));
}

/// Largest difference between the field and f at the integration points.
template <typename F>
double error(const mesh::Mesh& mesh, const TemperatureField& field, const F& f) {
  const Discretization discretization(mesh);
  std::vector<double> values(discretization.n_points());
  mechanics::TemperatureMemo memo;
  field.at_points(discretization, mesh)->evaluate(0, values, memo);
  double largest = 0;
  for (std::size_t p = 0; p < values.size(); ++p)
    largest = std::max(largest, std::abs(values[p] - f(discretization.point_coordinates()[p])));
  return largest;
}

double linear(const Vector3& x) {
  return 500 + 20 * x[0] - 30 * x[1] + 50 * x[2];
}
double quadratic(const Vector3& x) {
  return 100 * x[2] * x[2] + 10 * x[0] * x[2];
}

class NodalTemperatures : public testing::TestWithParam<CellType> {
 protected:
  const mesh::Mesh box_ = box_mesh(GetParam(), {2, 2, 3}, {1, 1, 4});
};

TEST_P(NodalTemperatures, AreInterpolatedByTheShapeFunctions) {
  const TemperatureField field = nodal(box_, linear);
  EXPECT_TRUE(field.cover(box_).is_nodal);
  EXPECT_EQ(field.cover(box_).mid_sides_given, field.cover(box_).mid_sides);
  EXPECT_LT(error(box_, field, linear), 1e-9);
  if (mesh::order(GetParam()) == 1) return;
  EXPECT_LT(error(box_, nodal(box_, quadratic), quadratic), 1e-9);
}

TEST_P(NodalTemperatures, AtCornersAloneAreThoseOfTheLinearElement) {
  const TemperatureField field = nodal(box_, linear, true);
  EXPECT_TRUE(field.cover(box_).is_nodal);
  EXPECT_LT(error(box_, field, linear), 1e-9);
  if (mesh::order(GetParam()) == 1) return;
  EXPECT_EQ(field.cover(box_).mid_sides_given, 0u);
  // Between the layers of nodes at which it is right.
  const auto layers = [](const Vector3& x) {
    const double h = 4.0 / 3, low = h * std::floor(x[2] / h), high = low + h;
    return 100 * (low * low + (high * high - low * low) * (x[2] - low) / h);
  };
  EXPECT_LT(error(box_,
                  nodal(
                      box_, [](const Vector3& x) { return 100 * x[2] * x[2]; }, true),
                  layers),
            1e-9);
}

INSTANTIATE_TEST_SUITE_P(Cells, NodalTemperatures,
                         testing::Values(CellType::hex8, CellType::hex20, CellType::tet4, CellType::tet10,
                                         CellType::wedge6, CellType::wedge15),
                         [](const auto& kind) { return std::string(mesh::name(kind.param)); });

/// By the integral of alpha T; linear elements by that of the straight lines between the nodes.
TEST(NodalTemperaturesOfABar, LengthenItByTheirIntegral) {
  constexpr double alpha = 1e-5, length = 4;
  constexpr int n = 4;
  const auto growth = [&](CellType type, const auto& f) {
    const mesh::Mesh bar = box_mesh(type, {1, 1, n}, {1, 1, length});
    material::Material material = elastic_material(200, 0);
    material.thermal_expansion = alpha;
    material.reference_temperature = 0;
    std::vector<mechanics::Support> supports{support(bar, "z0", Vector3::UnitZ(), 0.0)};
    for (const char* side : {"x0", "x1"}) supports.push_back(support(bar, side, Vector3::UnitX(), 0.0));
    for (const char* side : {"y0", "y1"}) supports.push_back(support(bar, side, Vector3::UnitY(), 0.0));
    const std::vector<double> u = solve(Body("bar", bar, material, supports, nodal(bar, f)));
    std::vector<double> end;
    for (const std::int64_t node : mesh::group_nodes(bar, "z1")) end.push_back(u[3 * node + 2]);
    const auto [least, most] = std::ranges::minmax(end);
    EXPECT_NEAR(least, most, 1e-12);  // it stays straight
    return end.front();
  };
  const auto in_z = [](const Vector3& x) { return 25 * x[2]; };
  const auto in_z2 = [](const Vector3& x) { return 25 * x[2] * x[2]; };
  for (const CellType type : {CellType::hex8, CellType::hex20})
    EXPECT_NEAR(growth(type, in_z), alpha * 25 * length * length / 2, 1e-12);
  EXPECT_NEAR(growth(CellType::hex20, in_z2), alpha * 25 * length * length * length / 3, 1e-12);
  double trapezoids = 0;
  for (int i = 0; i < n; ++i) trapezoids += 0.5 * (i * i + (i + 1) * (i + 1));
  EXPECT_NEAR(growth(CellType::hex8, in_z2), alpha * 25 * trapezoids, 1e-12);
}

TEST(NodalTemperaturesOfASection, AreInterpolatedByTheShapeFunctions) {
  const auto in_plane = [](const Vector3& x) { return 500 + 20 * x[0] - 30 * x[1]; };
  const auto curved = [](const Vector3& x) { return 100 * x[0] * x[0] + 10 * x[0] * x[1]; };
  for (const CellType type : {CellType::quad4, CellType::quad8, CellType::tri3, CellType::tri6})
    for (const settings::Analysis analysis : {settings::Analysis::plane_strain, settings::Analysis::axisymmetric}) {
      const mesh::Mesh section = section_mesh(type, {2, 3}, {1, 4}, {5, 0}, {analysis, 1.0});
      const TemperatureField field = nodal(section, in_plane);
      EXPECT_TRUE(field.cover(section).is_nodal);
      EXPECT_LT(error(section, field, in_plane), 1e-6) << mesh::name(type);
      if (mesh::order(type) == 1) continue;
      EXPECT_LT(error(section, nodal(section, curved), curved), 1e-4) << mesh::name(type);
    }
}

TEST(NodalTemperaturesOfAPart, AreThoseOfTheBody) {
  const mesh::Mesh box = box_mesh(CellType::hex20, {1, 1, 4}, {1, 1, 4});
  const Body body("bar", box, elastic_material(), symmetry_supports(box), nodal(box, quadratic));
  const std::vector<std::size_t> own{1, 3};
  const Body part = body.part(own, std::vector<char>(box.nodes.size(), 1));
  const std::vector<double> whole = body.at(0).temperature, of_part = part.at(0).temperature;
  for (std::size_t e = 0; e < own.size(); ++e)
    for (std::size_t p = 0; p < 8; ++p) EXPECT_EQ(of_part[8 * e + p], whole[8 * own[e] + p]);
}

TEST(NodalTemperaturesOfSomeNodes, AreScatteredPoints) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 4}, {1, 1, 4});
  ScatteredTemperatures given{box.nodes, {0}, {std::vector<double>(box.nodes.size(), 7)}};
  given.node_tolerance = tolerance;
  given.points.pop_back();
  given.values[0].pop_back();
  const TemperatureField field(std::move(given));
  EXPECT_FALSE(field.cover(box).is_nodal);
  EXPECT_EQ(field.cover(box).corners_given + 1, field.cover(box).corners);
  EXPECT_LT(error(box, field, [](const Vector3&) { return 7.0; }), 1e-12);
}

}  // namespace
}  // namespace nodal_temperature_tests
}  // namespace creepcontact::test
