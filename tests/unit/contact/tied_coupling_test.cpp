/// Tied surfaces whose meshes match, in whole or in part.
#include <gtest/gtest.h>

#include <cmath>

#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

using contact::ContactType;

/// Middle nodes back into the middles of straight edges.
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

/// Two boxes, one on the other; the faces of the upper one beyond x = `match` have other nodes, in the plane.
class PartlyMatched {
 public:
  PartlyMatched(CellType type, double match) {
    const auto moved = [&](const Vector3& x) {
      const double bump = x.x() > match ? x.x() * (x.x() - match) * (1 - x.x()) * x.y() * (1 - x.y()) : 0;
      return Vector3(x.x() + 0.9 * bump, x.y() - 0.6 * bump, x.z());
    };
    const mesh::Mesh low = box_mesh(type, {4, 3, 1}, {1, 1, 0.8}, {0, 0, -0.8}),
                     up = straightened(mapped(box_mesh(type, {4, 3, 1}, {1, 1, 0.6}), moved));
    std::vector<mechanics::Support> of_low = symmetry(low), of_up = symmetry(up);
    of_low.push_back(support(low, "z0", Vector3::UnitZ()));
    of_up.push_back(support(up, "z1", Vector3::UnitZ(), 0.014));
    std::vector<mechanics::Body> bodies;
    bodies.emplace_back("low", low, elastic_material(200), std::move(of_low), std::nullopt);
    bodies.emplace_back("up", up, elastic_material(200), std::move(of_up), std::nullopt);
    std::vector<contact::Pair> pairs(1);
    pairs[0].name = "joint";
    pairs[0].slave_body = 1;
    pairs[0].coupling = contact::tied_coupling(Boxes::surface(bodies[1], "z0"), Boxes::surface(bodies[0], "z1"));
    condensed = std::make_unique<Condensed>(std::move(bodies), std::move(pairs));
  }

  const contact::MortarCoupling& coupling() const { return condensed->pairs[0].coupling; }

  std::unique_ptr<Condensed> condensed;

 private:
  static std::vector<mechanics::Support> symmetry(const mesh::Mesh& mesh) {
    return {support(mesh, "x0", Vector3::UnitX()), support(mesh, "y0", Vector3::UnitY())};
  }
};

class TiedCoupling : public testing::TestWithParam<std::tuple<CellType, double>> {};

// A uniform tension crosses both parts; each multiplier node says so, those of the nodes between corners too.
TEST_P(TiedCoupling, CarriesUniformTension) {
  const auto [type, match] = GetParam();
  PartlyMatched boxes(type, match);
  const contact::MortarCoupling& coupling = boxes.coupling();
  const bool has_corner_faces = type == CellType::tet10;  // which have no node inside the surface
  EXPECT_EQ(coupling.ties.empty(), match < 0 && !has_corner_faces);
  EXPECT_EQ(coupling.ties.size() == coupling.nodes.size(), match >= 1);
  double area = 0;
  for (const double one : coupling.area) {
    EXPECT_GT(one, 0);
    area += one;
  }
  EXPECT_NEAR(area, 1, 1e-12);
  const auto solver = contact::active_set_solver(boxes.condensed->interface.problem());
  const ContactEquilibrium state = boxes.condensed->solve(*solver);
  for (const auto& stress : state.stress)
    for (std::size_t p = 0; p < stress.size(); p += 6) {
      EXPECT_NEAR(stress[p + 2], 2.0, 1e-9);
      EXPECT_NEAR(stress[p], 0.0, 1e-9);
    }
  Vector3 force = Vector3::Zero();
  for (std::size_t i = 0; i < coupling.nodes.size(); ++i) {
    EXPECT_NEAR(coupling.pressure(i, state.result.state.multiplier), -2, 1e-9);
    EXPECT_LT(coupling.shear(i, state.result.state.multiplier).norm(), 5e-9);
    force += coupling.nodal_force(i, state.result.state.multiplier);
  }
  EXPECT_NEAR(force.z(), 2, 1e-9);
}

// Any displacement in common leaves all rows zero where the faces match; a linear one everywhere.
TEST_P(TiedCoupling, LeavesCommonDisplacementsFree) {
  const auto [type, match] = GetParam();
  const PartlyMatched boxes(type, match);
  const contact::MortarCoupling& coupling = boxes.coupling();
  const auto field = [&](std::size_t body, bool linear) {
    return nodal_field(boxes.condensed->bodies[body].mesh(), [&](const Vector3& x) {
      return linear ? Vector3(x.x() + 0.3 * x.y(), 2 * x.y(), x.x() - x.y())
                    : Vector3(std::sin(3 * x.x()), x.x() * x.y() * x.y(), std::cos(x.y() + 2 * x.x()));
    });
  };
  for (const bool linear : {true, false}) {
    const std::vector<double> low = field(0, linear), up = field(1, linear);
    const Eigen::VectorXd gaps = coupling.slave_rows * Eigen::VectorXd::Map(up.data(), std::ssize(up)) +
                                 coupling.master_rows * Eigen::VectorXd::Map(low.data(), std::ssize(low));
    const Index n_ties = 3 * std::ssize(coupling.ties);
    EXPECT_LT(gaps.tail(n_ties).cwiseAbs().sum(), 1e-14);
    if (linear) {
      EXPECT_LT(gaps.norm(), 1e-14);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, TiedCoupling,
                         testing::Combine(testing::Values(CellType::hex8, CellType::hex20, CellType::tet10),
                                          testing::Values(-1.0, 0.5, 1.0)),
                         [](const auto& of) {
                           const double match = std::get<1>(of.param);
                           return std::string(mesh::name(std::get<0>(of.param))) + (match < 0   ? "_other"
                                                                                    : match < 1 ? "_half"
                                                                                                : "_all");
                         });

}  // namespace
}  // namespace creepcontact::test
