// The gap measured from the meshes against the exact distance of the surfaces that they approximate.
#include <gtest/gtest.h>

#include "../../../src/contact/geometry/segments.hpp"
#include "support/contact/curved_pair.hpp"

namespace creepcontact {
namespace {

using contact::ContactType;
using mesh::CellType;

struct GapCase {
  std::string name;
  CellType type;
  bool spherical, with_symmetry;
};

class CurvedGap : public testing::TestWithParam<GapCase> {
 protected:
  struct Errors {
    double mean = 0, nodal = 0;  // of the gap, largest over the nodes, [length]
  };

  static test::Part part(std::array<int, 3> divisions, double radius, bool is_inner) {
    const test::Shell shell{.type = GetParam().type, .divisions = divisions, .radius = radius, .is_inner = is_inner};
    return GetParam().spherical ? test::sphere(shell, GetParam().with_symmetry)
                                : test::cylinder(shell, GetParam().with_symmetry);
  }

  /// Radii 1 and 1 + delta, n_inner against n_outer facets a quadrant.
  static Errors errors(int n_inner, int n_outer, double delta, bool inner_is_slave) {
    const auto across = [](int n) { return GetParam().spherical ? n : 2; };
    const test::Part inner = part({n_inner, across(n_inner), 1}, 1.0, true);
    const test::Part outer = part({n_outer, across(n_outer) + 1, 1}, 1.0 + delta, false);
    const test::Part& slave = inner_is_slave ? inner : outer;
    const test::Part& master = inner_is_slave ? outer : inner;
    const auto coupling = contact::mortar_coupling(slave.surface(), master.surface(), ContactType::unilateral);
    Errors result;
    double area = 0;
    for (int i = 0; i < coupling.n_rows(); ++i) {
      const double own = coupling.area[i];
      result.nodal = std::max(result.nodal, std::abs(coupling.geometric_gap[i] / own - delta));
      area += own;
    }
    result.mean = std::abs(coupling.geometric_gap.sum() / area - delta);
    return result;
  }
};

TEST_P(CurvedGap, IsRightWithinTwoPercentAtEveryNode) {
  for (const bool inner_is_slave : {true, false})
    for (const auto& [n_inner, n_outer, delta] :
         {std::tuple{8, 11, 1e-3}, {8, 11, 1e-2}, {11, 8, 1e-3}, {9, 9, 1e-3}, {12, 9, 2e-3}, {16, 22, 1e-3}}) {
      const Errors error = errors(n_inner, n_outer, delta, inner_is_slave);
      // The quad8 faces of eight to this patch of the sphere are themselves up to 2.7e-5 off it, at its corner.
      const bool is_serendipity_sphere = GetParam().spherical && GetParam().type == CellType::hex20;
      EXPECT_LT(error.nodal, is_serendipity_sphere ? 3e-5 : 0.02 * delta)
          << n_inner << " on " << n_outer << ", " << delta;
      EXPECT_LT(error.mean, 0.01 * delta) << n_inner << " on " << n_outer << ", " << delta;
    }
}

// Quadratic faces are used as they are; interpolation by them is of third order, reached from below.
TEST_P(CurvedGap, ConvergesAtThirdOrderOrBetter) {
  const double coarse = errors(6, 8, 1e-2, true).nodal, fine = errors(12, 16, 1e-2, true).nodal;
  EXPECT_GT(std::log2(coarse / fine), mesh::order(GetParam().type) == 1 ? 3.5 : 2.9) << coarse << ", " << fine;
}

INSTANTIATE_TEST_SUITE_P(Pairs, CurvedGap,
                         testing::Values(GapCase{"hex8_quarter", CellType::hex8, false, true},
                                         GapCase{"hex8_open_arc", CellType::hex8, false, false},
                                         GapCase{"tet4_quarter", CellType::tet4, false, true},
                                         GapCase{"tet4_open_arc", CellType::tet4, false, false},
                                         GapCase{"hex20_quarter", CellType::hex20, false, true},
                                         GapCase{"tet10_open_arc", CellType::tet10, false, false},
                                         GapCase{"hex8_sphere", CellType::hex8, true, true},
                                         GapCase{"hex8_open_sphere", CellType::hex8, true, false},
                                         GapCase{"tet4_sphere", CellType::tet4, true, true},
                                         GapCase{"tet4_open_sphere", CellType::tet4, true, false},
                                         GapCase{"hex20_sphere", CellType::hex20, true, true},
                                         GapCase{"tet10_sphere", CellType::tet10, true, true}),
                         [](const auto& tested) { return tested.param.name; });

// What the reconstruction is for: eight chords a quadrant stand off their circle by up to 0.5 % of the radius.
TEST(GeometricGap, FacetsThemselvesAreFarOff) {
  const test::Part inner = test::cylinder({.divisions = {8, 2, 1}});
  const test::Part outer = test::cylinder({.divisions = {11, 3, 1}, .radius = 1.001, .is_inner = false});
  const auto slave = contact::make_facets(inner.mesh, inner.surface().faces);
  const auto master = contact::make_facets(outer.mesh, outer.surface().faces);
  double sum = 0, area = 0;
  for (std::size_t f = 0; f < slave.size(); ++f)
    for (const contact::Segment& segment : contact::Segmentation(slave, master).segments(f))
      for (const contact::SegmentPoint& point : segment.points) {
        const Vector3 normal = slave[f].area_vector_at_centre().normalized();
        sum += point.weight *
               normal.dot(master[segment.master].position(point.master_xi) - slave[f].position(point.slave_xi));
        area += point.weight;
      }
  EXPECT_GT(std::abs(sum / area - 1e-3), 1e-3);
}

TEST(GeometricGap, IsExactBetweenPlanes) {
  for (const CellType type : {CellType::hex8, CellType::tet4, CellType::hex20, CellType::tet10})
    for (const double slope : {0.0, 0.3}) {
      const test::Part lower(test::box_mesh(type, {3, 2, 1}, Vector3::Ones(), {0, 0, -1}), "z1");
      const test::Part upper(
          test::mapped(test::box_mesh(type, {2, 3, 1}),
                       [&](const Vector3& x) { return Vector3(x.x(), x.y(), x.z() + 0.05 + slope * x.x()); }),
          "z0");
      const auto coupling = contact::mortar_coupling(lower.surface(), upper.surface(), ContactType::unilateral);
      const Function exact = Function::expression("0.05 + " + std::to_string(slope) + "*x", {"x"});
      EXPECT_LT((coupling.geometric_gap - coupling.given_gap(exact, 0)).cwiseAbs().maxCoeff(), 1e-12)
          << mesh::name(type) << ", slope " << slope;
    }
}

// A blunt ridge must not make the plane faces beside it bulge, except where they touch it on both sides.
TEST(GeometricGap, StaysExactOnPlanesBesideAKink) {
  const auto roof = [](const Vector3& x) { return Vector3(x.x(), x.y(), x.z() - 0.2 * std::max(0.0, x.x() - 0.5)); };
  const test::Part lower(test::mapped(test::box_mesh(CellType::hex8, {8, 2, 1}, Vector3::Ones(), {0, 0, -1}), roof),
                         "z1");
  const test::Part upper(test::mapped(test::box_mesh(CellType::hex8, {6, 3, 1}, Vector3::Ones(), {0, 0, 0.01}), roof),
                         "z0");
  const auto coupling = contact::mortar_coupling(lower.surface(), upper.surface(), ContactType::unilateral);
  for (int i = 0; i < coupling.n_rows(); ++i) {
    const auto& node = coupling.nodes[i];
    const double x = lower.mesh.nodes[node.node].x();
    const double exact = x < 0.5 ? 0.01 : 0.01 / std::hypot(1, 0.2);
    if (std::abs(x - 0.5) < 0.15) continue;
    EXPECT_NEAR(coupling.geometric_gap[i] / coupling.area[i], exact, 1e-12) << x;
  }
}

}  // namespace
}  // namespace creepcontact
