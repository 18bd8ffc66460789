/// A body whose elements are spread over several processes: what the parts compute adds up to the whole.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "creepcontact/base/index.hpp"
#include "creepcontact/mechanics/body.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Body;

struct Parts {
  std::vector<Body> bodies;
  std::vector<std::vector<std::size_t>> points;  // of the whole body, in the order of the part
};

/// Every n-th element; forces at a node are in the part (node mod n). The last part has no elements.
Parts parts_of(const Body& whole, std::size_t n) {
  Parts parts;
  const mechanics::Discretization& all = whole.discretization();
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<std::size_t> elements;
    for (std::size_t e = 0; e < all.n_elements(); ++e)
      if (e % (n - 1) == k) elements.push_back(e);
    std::vector<char> loaded(whole.mesh().nodes.size());
    for (std::size_t i = 0; i < loaded.size(); ++i) loaded[i] = i % n == k ? 1 : 0;
    parts.bodies.push_back(whole.part(elements, loaded));
    std::vector<std::size_t>& points = parts.points.emplace_back();
    for (const std::size_t e : elements)
      for (std::size_t p = all.first_point(e); p < all.first_point(e + 1); ++p) points.push_back(p);
  }
  return parts;
}

class BodyPart : public testing::TestWithParam<CellType> {};

TEST_P(BodyPart, SumsAreThoseOfTheWholeBody) {
  const mesh::Mesh box = box_mesh(GetParam(), {3, 2, 2}, {3, 2, 1}, {0, 0, 0}, 0.2);
  material::Material material = elastic_material();
  material.thermal_expansion = 1e-5;
  Body whole("body", box, material, {support(box, "z0", Vector3::UnitZ()), support(box, "x1", Vector3::UnitX(), 0.01)},
             Function::expression("100*x+t", {"x", "t"}));
  whole.add_load(mechanics::pressure_load(box, mesh::boundary_faces(box, "y1"), 3.0));
  whole.add_load(mechanics::volume_load(whole.discretization(), {0.0, 5.0, Function::expression("x*t", {"x", "t"})}));
  const Parts parts = parts_of(whole, 3);
  ASSERT_TRUE(parts.bodies[0].own_elements().has_value());
  ASSERT_EQ(parts.bodies[2].discretization().n_points(), 0u);

  const Index n = whole.constraints().n_free();
  const std::size_t n_points = whole.discretization().n_points();
  std::vector<double> creep(6 * n_points), u(3 * box.nodes.size()), stress(6 * n_points);
  for (std::size_t i = 0; i < creep.size(); ++i) creep[i] = 1e-3 * std::sin(0.7 * static_cast<double>(i));
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 1e-3 * std::cos(0.3 * static_cast<double>(i));
  const mechanics::BodyConditions at = whole.at(2);
  std::vector<double> right(n), residual(n);
  whole.right_hand_side(at, {creep}, right);
  whole.discretization().stress(u, at.elastic(), {creep}, stress);
  whole.residual(at.external_forces(), stress, residual);
  linalg::SparseMatrix stiffness = whole.on_free_unknowns(whole.full_stiffness(at));

  Eigen::VectorXd right_sum = Eigen::VectorXd::Zero(n), residual_sum = right_sum;
  linalg::SparseMatrix stiffness_sum(n, n);
  for (std::size_t k = 0; k < parts.bodies.size(); ++k) {
    const Body& part = parts.bodies[k];
    const std::vector<std::size_t>& points = parts.points[k];
    std::vector<double> own_creep(6 * points.size()), own_stress(own_creep.size()), own(n);
    for (std::size_t i = 0; i < own_creep.size(); ++i) own_creep[i] = creep[6 * points[i / 6] + i % 6];
    const mechanics::BodyConditions here = part.at(2);
    part.right_hand_side(here, {own_creep}, own);
    right_sum += Eigen::VectorXd::Map(own.data(), n);
    part.discretization().stress(u, here.elastic(), {own_creep}, own_stress);
    for (std::size_t i = 0; i < own_stress.size(); ++i)
      ASSERT_NEAR(own_stress[i], stress[6 * points[i / 6] + i % 6], 1e-12 * std::abs(own_stress[i]) + 1e-12);
    part.residual(here.external_forces(), own_stress, own);
    residual_sum += Eigen::VectorXd::Map(own.data(), n);
    stiffness_sum += part.on_free_unknowns(part.full_stiffness(here));
  }
  const auto norm = [](const std::vector<double>& v) { return Eigen::VectorXd::Map(v.data(), std::ssize(v)).norm(); };
  EXPECT_LE((right_sum - Eigen::VectorXd::Map(right.data(), n)).norm(), 1e-12 * norm(right));
  EXPECT_LE((residual_sum - Eigen::VectorXd::Map(residual.data(), n)).norm(), 1e-12 * norm(residual));
  EXPECT_LE((stiffness_sum - stiffness).norm(), 1e-12 * stiffness.norm());
}

INSTANTIATE_TEST_SUITE_P(Elements, BodyPart,
                         testing::Values(CellType::tet4, CellType::tet10, CellType::hex8, CellType::hex20,
                                         CellType::wedge15),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

}  // namespace
}  // namespace creepcontact::test
