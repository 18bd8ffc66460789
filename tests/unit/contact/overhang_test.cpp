// Contact patch test where facets of either side stick out over the other's edge: one long body under two shorter ones
// that meet over the middle of its facets. Together they press everywhere, so the exact state is uniform, while each of
// the two pairs alone ends inside facets of the long body.
#include <gtest/gtest.h>

#include "support/contact/boxes.hpp"

namespace creepcontact {
namespace {

using contact::ContactType;
using contact::MortarCoupling;
using mesh::CellType;

constexpr double seam = 0.57;  // of the long body's length 1

/// Moves nodes within planes z = const, not those of the box's sides out of them.
Vector3 distorted(const Vector3& x, double left, double length, double amount) {
  const double s = (x.x() - left) / length, t = x.y();
  const double bump = amount * s * (1 - s) * t * (1 - t);
  return {x.x() + length * bump * (1 + t), x.y() - bump * (2 - s), x.z()};
}

/// Middle nodes back into the middles of straight edges (serendipity elements and tetrahedra).
mesh::Mesh straightened(mesh::Mesh mesh) {
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (mesh::order(block.type) == 1 || mesh::dimension(block.type) < 3) continue;
    for (std::size_t c = 0; c < block.size(); ++c) {
      const auto cell = block.cell(c);
      std::size_t middle = mesh::n_corners(block.type);
      for (const auto& [a, b] : mesh::cell_edges(block.type))
        mesh.nodes[cell[middle++]] = 0.5 * (mesh.nodes[cell[a]] + mesh.nodes[cell[b]]);
    }
  }
  return mesh;
}

struct OverhangCase {
  std::string name;
  CellType lower, upper;
  bool lower_is_slave;
  double distortion;  // 0: rectangles
  bool curved_edges;  // quadratic faces with curved edges in their plane
};

class Overhang : public testing::TestWithParam<OverhangCase> {
 protected:
  /// Boxes: the lower one, and two on it.
  static mesh::Mesh box(std::size_t b) {
    const double left = b == 2 ? seam : 0.0, length = b == 0 ? 1.0 : b == 1 ? seam : 1.0 - seam;
    const std::array<int, 3> divisions = b == 0   ? std::array{3, 3, 2}
                                         : b == 1 ? std::array{2, 2, 1}
                                                  : std::array{2, 4, 1};
    mesh::Mesh made = test::mapped(
        test::box_mesh(b == 0 ? GetParam().lower : GetParam().upper, divisions, {length, 1, 1},
                       {left, 0, b == 0 ? -1.0 : 0.0}),
        [&](const Vector3& x) { return distorted(x, left, length, GetParam().distortion * (b == 1 ? -1 : 1)); });
    return GetParam().curved_edges ? made : straightened(std::move(made));
  }

  static mechanics::Body body(std::size_t b, double squeeze) {
    mesh::Mesh made = box(b);
    std::vector<mechanics::Support> supports{
        test::support(made, "x0", Vector3::UnitX()), test::support(made, "y0", Vector3::UnitY()),
        test::support(made, b == 0 ? "z0" : "z1", Vector3::UnitZ(), b == 0 ? 0.0 : -squeeze)};
    return {std::to_string(b), std::move(made), test::elastic_material(), std::move(supports), std::nullopt};
  }

  static contact::Surface surface(const mechanics::Body& body, const char* group) {
    return {group, &body.mesh(), &body.constraints(), mesh::boundary_faces(body.mesh(), group), 1.0};
  }

  static MortarCoupling couple(const mechanics::Body& lower, const mechanics::Body& upper) {
    const contact::Surface low = surface(lower, "z1"), up = surface(upper, "z0");
    return GetParam().lower_is_slave ? contact::mortar_coupling(low, up, ContactType::unilateral)
                                     : contact::mortar_coupling(up, low, ContactType::unilateral);
  }
  static double tolerance() { return GetParam().curved_edges ? 1e-4 : 1e-8; }
};

/// Nodal forces of a unit pressure on a whole surface.
Eigen::VectorXd pressure_forces(const mesh::Mesh& mesh, const char* group) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * mesh.nodes.size());
  for (const mesh::Face& face : mesh::boundary_faces(mesh, group)) {
    const contact::Facet facet(mesh, face, {});
    const fem::QuadratureRule rule = facet.n_corners() == 3 ? fem::triangle(8) : fem::gauss_quadrilateral(5);
    contact::ShapeValues shape(facet.n_nodes());
    for (int q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q).transpose();
      facet.element().shape(xi, shape);
      for (int j = 0; j < facet.n_nodes(); ++j)
        forces.segment<3>(3 * face.nodes[j]) -= rule.weights[q] * shape[j] * facet.area_vector(xi);
    }
  }
  return forces;
}

TEST_P(Overhang, UnitPressureGivesTheConsistentNodalForces) {
  const auto lower = body(0, 0.0);
  Eigen::VectorXd on_lower = Eigen::VectorXd::Zero(3 * lower.mesh().nodes.size());
  for (const std::size_t b : {1, 2}) {
    const auto upper = body(b, 0.0);
    const MortarCoupling coupling = couple(lower, upper);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(coupling.n_rows());
    const contact::RowMatrix& lower_rows = GetParam().lower_is_slave ? coupling.slave_rows : coupling.master_rows;
    const contact::RowMatrix& upper_rows = GetParam().lower_is_slave ? coupling.master_rows : coupling.slave_rows;
    on_lower += lower_rows.transpose() * ones;
    const Eigen::VectorXd exact = pressure_forces(upper.mesh(), "z0");
    EXPECT_LT((upper_rows.transpose() * ones - exact).cwiseAbs().maxCoeff(), tolerance() * exact.cwiseAbs().maxCoeff());
  }
  const Eigen::VectorXd exact = pressure_forces(lower.mesh(), "z1");
  EXPECT_LT((on_lower - exact).cwiseAbs().maxCoeff(), tolerance() * exact.cwiseAbs().maxCoeff());
}

class OverhangState : public Overhang {};

TEST_P(OverhangState, IsUniform) {
  constexpr double squeeze = 0.02, pressure = 200.0 * squeeze / 2;
  std::vector<mechanics::Body> bodies;
  for (const std::size_t b : {0, 1, 2}) bodies.push_back(body(b, squeeze));
  std::vector<contact::Pair> pairs;
  for (const std::size_t b : {1, 2}) {
    contact::Pair pair;
    pair.name = std::to_string(b);
    pair.slave_body = GetParam().lower_is_slave ? 0 : b;
    pair.master_body = GetParam().lower_is_slave ? b : 0;
    pair.coupling = couple(bodies[0], bodies[b]);
    pairs.push_back(std::move(pair));
  }
  test::Condensed condensed(std::move(bodies), std::move(pairs));
  const test::ContactEquilibrium state = condensed.solve(*contact::active_set_solver(condensed.interface.problem()));
  const Eigen::VectorXd& multiplier = state.result.state.multiplier;
  for (int i = 0; i < multiplier.size(); ++i) EXPECT_NEAR(multiplier[i], pressure, tolerance() * pressure) << i;
  for (std::size_t b = 0; b < 3; ++b) {
    const std::vector<double>& stress = state.stress[b];
    for (std::size_t p = 0; p < stress.size(); p += 6)
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(stress[p + c], c == 2 ? -pressure : 0.0, tolerance() * pressure) << "body " << b;
  }
}

/// @param types_with_curved_edges  quadratic elements whose faces get curved edges
std::vector<OverhangCase> overhang_cases(const std::vector<CellType>& types_with_curved_edges) {
  std::vector<OverhangCase> cases;
  for (const bool lower_is_slave : {true, false}) {
    const std::string slave = lower_is_slave ? "_lower_slave" : "_upper_slave";
    for (const CellType type : {CellType::hex8, CellType::tet4, CellType::tet10, CellType::hex20}) {
      const std::string name = std::string(mesh::name(type)) + slave;
      cases.push_back({name, type, type, lower_is_slave, 0.0, false});
      cases.push_back({name + "_distorted", type, type, lower_is_slave, 0.4, false});
    }
    for (const CellType type : types_with_curved_edges)
      cases.push_back({std::string(mesh::name(type)) + slave + "_curved_edges", type, type, lower_is_slave, 0.4, true});
  }
  cases.push_back({"hex8_tet10_distorted", CellType::hex8, CellType::tet10, true, 0.4, false});
  cases.push_back({"hex20_tet4_distorted", CellType::hex20, CellType::tet4, false, 0.4, false});
  return cases;
}

std::string overhang_name(const testing::TestParamInfo<OverhangCase>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(Bodies, Overhang,
                         testing::ValuesIn(overhang_cases({CellType::tet10, CellType::hex20, CellType::hex27})),
                         overhang_name);
// A hex20 with curved edges holds no uniform stress even alone: its reduced rule misses the exact nodal forces by 2e-3.
INSTANTIATE_TEST_SUITE_P(Bodies, OverhangState, testing::ValuesIn(overhang_cases({CellType::tet10, CellType::hex27})),
                         overhang_name);

}  // namespace
}  // namespace creepcontact
