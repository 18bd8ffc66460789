/// The body: errors of the model, time, supports along inclined normals.
#include "creepcontact/mechanics/body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"
#include "support/says.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Body;
using mechanics::Support;

/// Loads that are in equilibrium strain a free body as if it were held anywhere, whatever its fixing dofs.
TEST(Body, FreeBodyUnderBalancedLoads) {
  const mesh::Mesh box = box_mesh(CellType::hex20, {2, 2, 2}, {2, 2, 2}, {-1, -1, -1});
  Body body("ball", box, elastic_material(), {}, std::nullopt);
  ASSERT_EQ(body.free_motions().size(), 6u);
  EXPECT_TRUE(says(body.free_motions()[2].description, {"translation", " z"}));
  for (const char* side : {"z0", "z1"})
    body.add_load(mechanics::pressure_load(box, mesh::boundary_faces(box, side), 3.0));
  const mechanics::BodyConditions at = body.at(0);
  std::vector<double> right_hand_side(body.constraints().n_free()), resultant(6);
  body.right_hand_side(at, {}, right_hand_side);
  EXPECT_GE(body.external_resultant(at, resultant), 2 * 3.0 * 4) << "sum of the absolute forces";
  body.clear_fixing_dofs(right_hand_side);
  for (const double work : resultant) EXPECT_NEAR(work, 0, 1e-12);
  std::vector<double> displacement(3 * box.nodes.size()), stress(6 * body.discretization().n_points());
  mechanics::FactoredBody factor = factored(body);
  solve_in_place(factor, right_hand_side);
  body.constraints().expand(right_hand_side, at.prescribed, displacement);
  body.discretization().stress(displacement, at.elastic(), {}, stress);
  for (const Tensor6& s : as_tensors(stress)) {
    EXPECT_NEAR(s[2], -3, 1e-10);
    EXPECT_NEAR(s[0], 0, 1e-10);
  }
}

/// Bodies have the same inputs of the stiffness where they have the same stiffness.
TEST(Body, InputsOfTheStiffnessTellItApart) {
  const auto make = [](double length, double young_modulus, const Vector3& held, double value, const char* on) {
    const mesh::Mesh box = box_mesh(CellType::hex20, {2, 1, 1}, {length, 1, 1});
    material::Material material = elastic_material();
    material.young_modulus = young_modulus;
    Support support{on, mesh::group_nodes(box, on), {held.normalized()}, value};
    return Body("box", box, material, {support}, std::nullopt);
  };
  const Body body = make(2, 2e5, Vector3::UnitX(), 0, "x0");
  const auto stiffness = [](const Body& of) { return of.on_free_unknowns(of.full_stiffness(of.at(0))); };
  const linalg::MatrixInputs inputs = body.stiffness_inputs(body.at(0));
  const Body moved = make(2, 2e5, Vector3::UnitX(), 0.1, "x0");
  EXPECT_EQ(moved.stiffness_inputs(moved.at(0)), inputs);
  EXPECT_EQ((stiffness(moved) - stiffness(body)).norm(), 0);
  for (const Body& other : {make(2.1, 2e5, Vector3::UnitX(), 0, "x0"), make(2, 2.1e5, Vector3::UnitX(), 0, "x0"),
                            make(2, 2e5, Vector3::UnitY(), 0, "x0"), make(2, 2e5, Vector3(1, 0.1, 0), 0, "x0"),
                            make(2, 2e5, Vector3::UnitX(), 0, "x1")})
    EXPECT_NE(other.stiffness_inputs(other.at(0)), inputs);
  const std::vector<std::size_t> elements{1};
  const Body part = body.part(elements, std::vector<char>(body.mesh().nodes.size(), 1));
  EXPECT_NE(part.stiffness_inputs(part.at(0)), inputs);
}

TEST(Body, ResultantsOfALoadOnAFreeBody) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1}, {2, 2, 2}, {-1, -1, -1});
  Body body("ring", box, elastic_material(), {support(box, "z0", Vector3::UnitZ())}, std::nullopt);
  ASSERT_EQ(body.free_motions().size(), 3u);  // along x, along y, about z
  body.add_load(mechanics::traction_load(box, mesh::boundary_faces(box, "x1"), {0.0, 5.0, 0.0}));
  std::vector<double> resultant(3);
  body.external_resultant(body.at(0), resultant);
  EXPECT_NEAR(resultant[0], 0, 1e-12);
  EXPECT_NEAR(resultant[1], 5.0 * 4, 1e-10);
  EXPECT_NEAR(resultant[2], 5.0 * 4 / std::sqrt(2.0), 1e-10) << "the corner at distance sqrt 2 moves by 1";
}

/// Nodal forces of thermal strain and of prescribed displacements are no loads, however large: not even their round-off
/// counts.
TEST(Body, ResultantsAreThoseOfExternalForcesAlone) {
  const mesh::Mesh box = box_mesh(CellType::hex20, {3, 3, 3});
  material::Material material = elastic_material();
  material.young_modulus = 7.7e8;
  material.poisson_ratio = 0.4999999;
  material.thermal_expansion = 1e-5;
  Body body("ring", box, material, {support(box, "x0", Vector3::UnitX(), 1e-3)},
            mechanics::TemperatureField(Function(20.0)));
  std::vector<double> resultant(body.free_motions().size());
  ASSERT_EQ(resultant.size(), 3u);
  EXPECT_EQ(body.external_resultant(body.at(0), resultant), 0);
  for (const double work : resultant) EXPECT_EQ(work, 0);
  body.add_load(mechanics::traction_load(box, mesh::boundary_faces(box, "z1"), {0.0, 0.0, 0.2}));
  body.external_resultant(body.at(0), resultant);
  EXPECT_NEAR(resultant[1], 0.2, 1e-12) << "along z";
}

/// Two cubes that share an edge only, one of them held.
TEST(Body, TurnsAboutAHinge) {
  mesh::Mesh mesh = box_mesh(CellType::hex8, {2, 1, 2});
  auto& cells = mesh.blocks[0].connectivity;
  const std::vector<std::int64_t> first(cells.begin(), cells.begin() + 8), last(cells.end() - 8, cells.end());
  mesh.blocks[0].connectivity = first;
  mesh.blocks[0].connectivity.insert(mesh.blocks[0].connectivity.end(), last.begin(), last.end());
  mesh.groups["volume"].cells.resize(2);
  const mesh::Mesh hinged = mesh::extract(mesh, {"volume"}).mesh;
  std::vector<Support> supports;
  for (int i = 0; i < 3; ++i) supports.push_back(support(hinged, "x0", Vector3::Unit(i)));
  Body body("chain", hinged, elastic_material(), supports, std::nullopt);
  ASSERT_EQ(body.free_motions().size(), 1u);
  EXPECT_NE(body.free_motions()[0].description.find("mechanism"), std::string::npos);
  EXPECT_NO_THROW(factored(body));
}

/// Two cubes apart from each other in one body.
TEST(Body, MovesInParts) {
  mesh::Mesh mesh = box_mesh(CellType::hex8, {3, 1, 1}, {3, 1, 1});
  auto& cells = mesh.blocks[0].connectivity;
  cells.erase(cells.begin() + 8, cells.begin() + 16);
  mesh.groups["volume"].cells.resize(2);
  const mesh::Mesh apart = mesh::extract(mesh, {"volume"}).mesh;
  Body body("stack", apart, elastic_material(), {support(apart, "z0", Vector3::UnitZ())}, std::nullopt);
  ASSERT_EQ(body.free_motions().size(), 6u);
  EXPECT_TRUE(says(body.free_motions()[0].description, {"translation", " x", "(0.5, 0.5, 0.5)"}));
  EXPECT_NO_THROW(factored(body));
}

Matrix6 hooke(const material::Moduli& moduli) {
  Matrix6 result;
  for (int j = 0; j < 6; ++j) result.col(j) = material::stress(moduli, Tensor6::Unit(j));
  return result;
}

TEST(Body, StiffnessOfElasticModuliIsTheElasticOne) {
  // A block on a slope, an unconstrained one (fixing dofs), a row that needs its hourglass modes held.
  const mesh::Mesh block = box_mesh(CellType::hex8, {2, 2, 2}), row = box_mesh(CellType::hex20, {4, 1, 1}, {4, 1, 1});
  const std::vector<Support> slope{support(block, "z0", Vector3(0, 0.6, 0.8)), support(block, "x0", Vector3::Unit(0))};
  for (const auto& [mesh, supports] :
       {std::pair(block, slope), std::pair(block, std::vector<Support>()), std::pair(row, symmetry_supports(row))}) {
    Body body("body", mesh, elastic_material(), supports, std::nullopt);
    const mechanics::FactoredBody factor = factored(body);
    const mechanics::BodyConditions at = body.at(0);
    const std::vector<Matrix6> moduli(body.discretization().n_points(), hooke(at.elastic().at(0)));
    const linalg::SparseMatrix elastic = factor.stiffness(at), general = factor.stiffness(moduli);
    ASSERT_EQ(general.nonZeros(), elastic.nonZeros());
    EXPECT_LT((general - elastic).norm(), 1e-13 * elastic.norm());
    const auto second = factor.solver().same_pattern();
    second->factorize(general);
    EXPECT_NEAR(second->rcond() / factor.solver().rcond(), 1, 1e-6);
  }
}

/// The reduced integration of hex20 misses motions of elements in a single row.
TEST(Body, BarOfSingleHex20ElementsStretchesAsItShould) {
  const mesh::Mesh bar = box_mesh(CellType::hex20, {6, 1, 1}, {6, 1, 1});
  std::vector<Support> clamped;
  for (int i = 0; i < 3; ++i) clamped.push_back(support(bar, "x0", Vector3::Unit(i)));
  for (const bool bent : {false, true}) {
    Body body("bar", bar, elastic_material(), bent ? clamped : symmetry_supports(bar), std::nullopt);
    body.add_load(
        mechanics::traction_load(bar, mesh::boundary_faces(bar, "x1"), {bent ? 0.0 : 2.0, 0.0, bent ? 0.001 : 0.0}));
    const std::vector<double> u = solve(body);
    if (bent) {
      double end = 0;  // mean over the end: weights of a quadrilateral of eight nodes
      for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
        const Vector3& x = bar.nodes[i];
        const bool is_corner = std::abs(x.y() - 0.5) > 0.4 && std::abs(x.z() - 0.5) > 0.4;
        if (x.x() > 6 - 1e-9) end += (is_corner ? -1.0 / 12 : 1.0 / 3) * u[3 * i + 2];
      }
      // Timoshenko's beam, F = 0.001, I = 1/12, E = 200, nu = 0.3.
      EXPECT_NEAR(end, 0.001 * (6.0 * 6 * 6 / (3 * 200 / 12.0) + 1.2 * 6 / (200 / 2.6)), 0.04 * end)
          << "the clamp stiffens it: fine meshes end 1.4 % below";
    } else {
      for (const Tensor6& s : as_tensors(stress_of(body, u))) EXPECT_NEAR(s[0], 2.0, 1e-9);
    }
  }
}

TEST(Body, LoadsThatAreNoNumbersAreAnError) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1});
  const auto pressure = [&](const char* expression) {
    return mechanics::pressure_load(box, mesh::boundary_faces(box, "z1"), Function::expression(expression, {"x", "t"}));
  };
  Body body("lid", box, elastic_material(), symmetry_supports(box), std::nullopt);
  const std::string at_once = message_of<ModelError>([&] { body.add_load(pressure("sqrt(-1 - x)")); });
  EXPECT_TRUE(says(at_once, {"body 'lid'", "finite", "t = 0"}));
  body.add_load(pressure("1/(2 - t)"));
  EXPECT_NO_THROW(body.at(1.0));
  const std::string later = message_of<ModelError>([&] { body.at(2.0); });
  EXPECT_TRUE(says(later, {"body 'lid'", "finite", "t = 2"}));
}

TEST(Body, FollowsTimeInLoadsAndSupports) {
  const mesh::Mesh bar = box_mesh(CellType::hex20, {2, 1, 1}, {2, 1, 1});
  std::vector<Support> supports = symmetry_supports(bar);
  supports.push_back(support(bar, "x1", Vector3::UnitX(), Function::expression("0.01*t", {"t"})));
  Body body("bar", bar, elastic_material(), supports, std::nullopt);
  body.add_load(mechanics::pressure_load(bar, mesh::boundary_faces(bar, "y1"), Function::expression("3*t", {"t"})));
  for (const double t : {1.0, 0.5, 2.0, 0.0}) {
    const std::vector<double> stress = stress_of(body, solve(body, t), t);
    for (const Tensor6& s : as_tensors(stress)) {
      EXPECT_NEAR(s[1], -3 * t, 1e-11);
      EXPECT_NEAR(s[0], 200 * 0.005 * t + 0.3 * -3 * t, 1e-11);
      EXPECT_NEAR(s.tail<4>().norm(), 0, 1e-11);
    }
  }
}

/// A box turned in space, on supports along its own normals, pressed: the turned solution of the straight box.
TEST(Body, SlidesOnInclinedSupports) {
  const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  const mesh::Mesh box =
      mapped(box_mesh(CellType::tet10, {2, 2, 2}), [&](const Vector3& x) { return Vector3(turn * x); });
  std::vector<Support> supports;
  int axis = 0;
  for (const auto* surface : {"x0", "y0", "z0"}) {
    const auto nodes = mesh::group_nodes(box, surface);
    supports.push_back({surface, nodes, mechanics::nodal_normals(box, mesh::boundary_faces(box, surface), nodes), 0.0});
    EXPECT_LT((supports.back().directions[0] + turn.col(axis++)).norm(), 1e-14);
  }
  Body body("box", box, elastic_material(), supports, std::nullopt);
  body.add_load(mechanics::pressure_load(box, mesh::boundary_faces(box, "z1"), 5.0));
  const std::vector<double> u = solve(body);
  const Matrix3 strain = turn * Vector3(0.3, 0.3, -1).asDiagonal() * turn.transpose() * 5.0 / 200.0;
  const std::vector<double> exact = nodal_field(box, [&](const Vector3& x) { return Vector3(strain * x); });
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], exact[i], 1e-14);
}

TEST(Body, RightHandSideIsLinearInTheCreepStrain) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {2, 2, 2});
  material::Material material = elastic_material();
  material.thermal_expansion = 1e-5;
  std::vector<Support> supports = symmetry_supports(box);
  supports.push_back(support(box, "x1", Vector3::UnitX(), 0.01));
  Body body("block", box, material, supports, Function(100.0));
  body.add_load(mechanics::volume_load(body.discretization(), {0.0, 1.0, 0.0}));
  std::vector<double> creep(6 * body.discretization().n_points());
  for (std::size_t i = 0; i < creep.size(); ++i) creep[i] = std::sin(static_cast<double>(i));
  const std::size_t n = body.constraints().n_free();
  std::vector<double> with(n), without(n), alone(n);
  const mechanics::BodyConditions at = body.at(0);
  body.right_hand_side(at, {creep, 6}, with);
  body.right_hand_side(at, {}, without);
  body.initial_strain_force({at.moduli}, {creep, 6}, alone);
  EXPECT_GT(largest(without), 0.01);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(with[i], without[i] + alone[i], 1e-11);
}

TEST(Body, RefusesInadmissibleElasticConstants) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {1, 1, 1});
  EXPECT_TRUE(says(message_of<ModelError>([&] { Body("b", box, elastic_material(200, 0.5), {}, std::nullopt); }),
                   {"material 'elastic'", "young_modulus 200", "poisson_ratio 0.5"}));
  EXPECT_TRUE(says(message_of<ModelError>([&] { Body("b", box, elastic_material(0, 0.3), {}, std::nullopt); }),
                   {"material 'elastic'", "young_modulus 0", "poisson_ratio 0.3"}));
}

TEST(Body, EstimatesTheMemoryOfItsFactor) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {4, 4, 4});
  Body body("b", box, elastic_material(), symmetry_supports(box), std::nullopt);
  const mechanics::FactoredBody factor = factored(body);
  EXPECT_EQ(mechanics::estimate_factor_bytes(body), factor.solver().factor_bytes() + factor.solver().work_bytes());
}

/// The trailing unknowns: L22 L22^T is the inverse of the compliance seen from them.
TEST(Body, EliminatesTheContactUnknownsLast) {
  const mesh::Mesh box = box_mesh(CellType::hex8, {2, 2, 2});
  Body body("b", box, elastic_material(), symmetry_supports(box), std::nullopt);
  std::vector<std::int64_t> trailing;
  for (const std::int64_t node : mesh::group_nodes(box, "x1"))
    trailing.push_back(body.constraints().free_index(node)[2]);
  mechanics::FactoredBody factor = factored(body, trailing);
  const Eigen::MatrixXd l = factor.solver().trailing_factor();
  const std::size_t n = body.constraints().n_free();
  const Index m = trailing.size();
  Eigen::MatrixXd compliance(m, m);
  for (Index j = 0; j < m; ++j) {
    std::vector<double> b(n, 0.0);
    b[trailing[j]] = 1;
    solve_in_place(factor, b);
    for (Index i = 0; i < m; ++i) compliance(i, j) = b[trailing[i]];
  }
  EXPECT_LT((l * l.transpose() * compliance - Eigen::MatrixXd::Identity(m, m)).norm(), 1e-11);
}

}  // namespace
}  // namespace creepcontact::test
