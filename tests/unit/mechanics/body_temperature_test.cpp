/// The body under a temperature: its elastic constants, steady or not, and the factor of another time.
#include <gtest/gtest.h>

#include "creepcontact/mechanics/body.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Body;
using mechanics::Support;

TEST(BodyInHeat, TakesTheElasticConstantsOfASteadyTemperature) {
  const mesh::Mesh bar = box_mesh(CellType::hex8, {2, 1, 1}, {2, 1, 1});
  material::Material material = elastic_material();
  material.young_modulus = Function::expression("200 - T", {"T"});
  Body body("bar", bar, material, symmetry_supports(bar), Function::expression("100*(x > 1)", {"x"}));
  body.add_load(mechanics::traction_load(bar, mesh::boundary_faces(bar, "x1"), {1.0, 0.0, 0.0}));
  EXPECT_EQ(body.at(0).moduli.size(), body.discretization().n_points());
  material.poisson_ratio = 0.0;
  Body slender("bar", bar, material, symmetry_supports(bar), Function::expression("100*(x > 1)", {"x"}));
  slender.add_load(mechanics::traction_load(bar, mesh::boundary_faces(bar, "x1"), {1.0, 0.0, 0.0}));
  const std::vector<double> u = solve(slender);
  for (const std::int64_t node : mesh::group_nodes(bar, "x1")) EXPECT_NEAR(u[3 * node], 1.0 / 200 + 1.0 / 100, 1e-13);
  Body uniform("bar", bar, material, symmetry_supports(bar), Function(50.0));
  const mechanics::BodyConditions at = uniform.at(0);
  ASSERT_EQ(at.moduli.size(), 1u);
  EXPECT_NEAR(at.elastic().at(3).mu, 75.0, 1e-12);
}

/// Half the bar heats up; its stiffness at every time is that of a bar with these constants.
TEST(BodyInHeat, FollowsElasticConstantsThatChangeInTime) {
  const mesh::Mesh bar = box_mesh(CellType::hex8, {2, 1, 1}, {2, 1, 1});
  material::Material material = elastic_material();
  material.young_modulus = Function::expression("200 - T", {"T"});
  material.poisson_ratio = 0.0;
  const auto body_at = [&](const Function& temperature) {
    Body body("bar", bar, material, symmetry_supports(bar), temperature);
    body.add_load(mechanics::traction_load(bar, mesh::boundary_faces(bar, "x1"), {1.0, 0.0, 0.0}));
    return body;
  };
  Body body = body_at(Function::expression("100*(x > 1)*t", {"x", "t"}));
  EXPECT_TRUE(body.stiffness_changes());
  mechanics::FactoredBody factor = factored(body);
  const mechanics::BodyConditions later = body.at(0.5);
  EXPECT_EQ(factor.time(), 0.0);
  EXPECT_NEAR(factor.stiffness_ratio(later).first, 0.75, 1e-14);
  EXPECT_NEAR(factor.stiffness_ratio(later).second, 1.0, 1e-14);
  EXPECT_NEAR(factor.elastic().at(body.discretization().n_points() - 1).mu, 100, 1e-12);
  factor.factorize(later);
  EXPECT_EQ(factor.time(), 0.5);
  EXPECT_EQ(factor.stiffness_ratio(later), std::pair(1.0, 1.0));
  std::vector<double> free(body.constraints().n_free()), u(3 * bar.nodes.size());
  body.right_hand_side(later, {}, free);
  solve_in_place(factor, free);
  body.constraints().expand(free, later.prescribed, u);
  for (const std::int64_t node : mesh::group_nodes(bar, "x1")) EXPECT_NEAR(u[3 * node], 1.0 / 200 + 1.0 / 150, 1e-13);

  const Body steady = body_at(Function::expression("100*(x > 1)", {"x"}));
  EXPECT_FALSE(steady.stiffness_changes());
  EXPECT_EQ(factored(steady).stiffness_ratio(steady.at(0.5)), std::pair(1.0, 1.0));
}

/// The residual of a displacement is the part of the forces that its stress does not carry.
TEST(FactoredBody, HasNoResidualInEquilibrium) {
  const mesh::Mesh box = box_mesh(CellType::hex20, {6, 1, 1}, {6, 1, 1});  // a single row: hourglass modes are held
  std::vector<Support> supports;
  for (int i = 0; i < 3; ++i) supports.push_back(support(box, "x0", Vector3::Unit(i), 0.01 * i));
  Body body("row", box, elastic_material(), supports, std::nullopt);
  body.add_load(mechanics::traction_load(box, mesh::boundary_faces(box, "x1"), {1.0, 0.5, 0.0}));
  mechanics::FactoredBody factor = factored(body);
  const mechanics::BodyConditions at = body.at(0);
  const std::size_t n = body.constraints().n_free();
  std::vector<double> load(n), free(n), u(3 * box.nodes.size()), rest(n);
  body.right_hand_side(at, {}, load);
  for (const double part : {1.0, 0.25}) {
    for (std::size_t i = 0; i < n; ++i) free[i] = part * load[i];
    solve_in_place(factor, free);
    body.constraints().expand(free, at.prescribed, u);
    factor.residual(at.external_forces(), stress_of(body, u), free, rest);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(rest[i], (1 - part) * load[i], 1e-10);
  }
}

TEST(BodyInHeat, KnowsItsTemperature) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1});
  Body body("b", box, elastic_material(), {}, Function::expression("x + 10*t", {"x", "t"}));
  mechanics::BodyConditions reused;
  for (const double t : {0.0, 2.0}) {
    body.update(t, reused);
    EXPECT_EQ(reused.temperature, body.at(t).temperature);
    const std::vector<double>& temperature = reused.temperature;
    for (std::size_t p = 0; p < temperature.size(); ++p)
      EXPECT_NEAR(temperature[p], body.discretization().point_coordinates()[p][0] + 10 * t, 1e-14);
  }
  Body cold("b", box, elastic_material(), {}, std::nullopt);
  EXPECT_TRUE(cold.at(1.0).temperature.empty());
}

}  // namespace
}  // namespace creepcontact::test
