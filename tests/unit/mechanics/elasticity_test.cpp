/// One body, exact states: patch tests, bars, locking, thermal expansion, reactions.
#include <gtest/gtest.h>

#include "creepcontact/base/error.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Body;

class ExactState : public testing::TestWithParam<CellType> {};
INSTANTIATE_TEST_SUITE_P(Types, ExactState, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& type) { return std::string(mesh::name(type.param)); });

TEST_P(ExactState, PassesThePatchTest) {
  const mesh::Mesh patch = box_mesh(GetParam(), {3, 3, 2}, {1.0, 1.2, 0.8}, {0.3, -0.2, 0.1}, 0.2);
  Body body("patch", patch, elastic_material(),
            boundary_supports(patch, {"1e-3*(1 + x + 2*y - z)", "1e-3*(2*x - y + 3*z)", "1e-3*(x + y + 4*z)"}),
            std::nullopt);
  Matrix3 gradient;
  gradient << 1, 2, -1, 2, -1, 3, 1, 1, 4;
  gradient *= 1e-3;
  const Tensor6 exact = material::stress(material::lame(200.0, 0.3), tensor::from_matrix(gradient));
  const std::vector<double> stress = stress_of(body, solve(body));
  for (const auto& at_point : as_tensors(stress)) EXPECT_LT((at_point - exact).norm(), 1e-10 * exact.norm());
}

TEST_P(ExactState, ExtendsABarExactly) {
  const mesh::Mesh bar = box_mesh(GetParam(), {3, 2, 2}, {3.0, 1.0, 1.0}, Vector3::Zero(), 0.2);
  Body body("bar", bar, elastic_material(), symmetry_supports(bar), std::nullopt);
  body.add_load(mechanics::traction_load(bar, mesh::boundary_faces(bar, "x1"), {5.0, 0.0, 0.0}));
  const std::vector<double> u = solve(body);
  const std::vector<double> exact =
      nodal_field(bar, [](const Vector3& x) { return Vector3(0.025 * x[0], -0.0075 * x[1], -0.0075 * x[2]); });
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], exact[i], 1e-12);
}

TEST_P(ExactState, ReactionsBalanceTheLoads) {
  const mesh::Mesh box = box_mesh(GetParam(), {2, 2, 2});
  std::vector<mechanics::Support> supports;
  for (int i = 0; i < 3; ++i) supports.push_back(support(box, "z0", Vector3::Unit(i)));
  Body body("block", box, elastic_material(), supports, std::nullopt);
  body.add_load(mechanics::traction_load(box, mesh::boundary_faces(box, "z1"),
                                         {1.0, -2.0, Function::expression("x*y", {"x", "y"})}));
  body.add_load(mechanics::volume_load(body.discretization(), {0.0, 3.0, 0.5}));
  std::vector<double> reactions(3 * box.nodes.size());
  const mechanics::BodyConditions at = body.at(0);
  body.residual_forces(at, stress_of(body, solve(body)), reactions);
  EXPECT_LT((resultant(reactions) + resultant(at.external_forces())).norm(), 1e-12);
  EXPECT_LT((resultant(reactions) - Vector3(-1, -1, -0.75)).norm(), 1e-11);
  for (std::size_t node = 0; node < box.nodes.size(); ++node) {
    if (body.constraints().n_held(node) > 0) continue;
    EXPECT_LT(Eigen::Map<Vector3>(&reactions[3 * node]).norm(), 1e-12);
  }
}

TEST_P(ExactState, ExpandsFreelyWithoutStress) {
  const mesh::Mesh box = box_mesh(GetParam(), {2, 2, 2}, {1.0, 2.0, 1.0}, Vector3::Zero(), 0.2);
  material::Material material = elastic_material();
  material.thermal_expansion = Function::expression("1e-5 + 1e-8*T", {"T"});
  material.reference_temperature = 20;
  Body body("block", box, material, symmetry_supports(box), Function::expression("20 + 100*t", {"t"}));
  const double strain = (1e-5 + 1e-8 * 220) * 200;
  const std::vector<double> u = solve(body, 2.0);
  const std::vector<double> exact = nodal_field(box, [&](const Vector3& x) { return Vector3(strain * x); });
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], exact[i], 1e-14);
  EXPECT_LT(largest(stress_of(body, u, 2.0)), 1e-11);
}

TEST_P(ExactState, UniformCreepStrainOfAFreeBlockGivesNoStress) {
  const mesh::Mesh box = box_mesh(GetParam(), {2, 2, 2}, Vector3::Ones(), Vector3::Zero(), 0.2);
  Body body("block", box, elastic_material(), symmetry_supports(box), std::nullopt);
  constexpr std::size_t stride = 8;  // two further state variables a point
  std::vector<double> state(stride * body.discretization().n_points(), 1e3);
  const Tensor6 creep = (Tensor6() << 2e-3, -1e-3, -1e-3, 0, 0, 0).finished();
  for (std::size_t p = 0; p < body.discretization().n_points(); ++p)
    std::copy_n(creep.data(), 6, state.data() + stride * p);
  const mechanics::CreepStrainView view{state, stride};
  const std::vector<double> u = solve(body, 0, view);
  EXPECT_LT(largest(stress_of(body, u, 0, view)), 1e-12);
  const std::vector<double> exact =
      nodal_field(box, [](const Vector3& x) { return Vector3(2e-3 * x[0], -1e-3 * x[1], -1e-3 * x[2]); });
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], exact[i], 1e-14);
}

TEST(Elasticity, OneElementWithThreeSymmetryPlanesIsNotSingular) {
  for (const CellType type : {CellType::hex20, CellType::hex8, CellType::hex27}) {
    const mesh::Mesh one = box_mesh(type, {1, 1, 1});
    Body body("cube", one, elastic_material(), symmetry_supports(one), std::nullopt);
    EXPECT_NO_THROW(factored(body));
  }
}

/// Thick cylinder sector, nearly incompressible, plane strain: the bore displacement relative to Lame's.
double bore_displacement_ratio(CellType type) {
  constexpr double a = 1.0, b = 2.0, young = 200.0, nu = 0.4999, angle = std::numbers::pi / 6;
  const mesh::Mesh sector = mapped(box_mesh(type, {10, 6, 1}, {b - a, angle, 0.2}), [&](const Vector3& x) {
    return Vector3((a + x[0]) * std::cos(x[1]), (a + x[0]) * std::sin(x[1]), x[2]);
  });
  const std::vector<mechanics::Support> supports{
      support(sector, "y0", Vector3::UnitY()), support(sector, "y1", {-std::sin(angle), std::cos(angle), 0}),
      support(sector, "z0", Vector3::UnitZ()), support(sector, "z1", Vector3::UnitZ())};
  Body body("ring", sector, elastic_material(young, nu), supports, std::nullopt);
  body.add_load(mechanics::pressure_load(sector, mesh::boundary_faces(sector, "x0"), 1.0));
  const std::vector<double> u = solve(body);
  const double exact = (1 + nu) / young * a * a / (b * b - a * a) * ((1 - 2 * nu) * a + b * b / a);
  const auto bore = mesh::group_nodes(sector, "x0");
  double sum = 0;
  for (const std::int64_t node : bore) {
    const Vector3& x = sector.nodes[node];
    sum += Vector3::Map(&u[3 * node]).dot(x) / a;
  }
  return sum / static_cast<double>(bore.size()) / exact;
}

TEST(Elasticity, BBarDoesNotLockWhereTheMaterialIsNearlyIncompressible) {
  EXPECT_NEAR(bore_displacement_ratio(CellType::hex8), 1.0, 0.01);
  EXPECT_NEAR(bore_displacement_ratio(CellType::hex20), 1.0, 1e-3);
}

}  // namespace
}  // namespace creepcontact::test
