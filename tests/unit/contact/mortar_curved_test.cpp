// Rows of the coupling on curved surfaces: balance of force and moment, and motions that contact leaves free.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "support/contact/curved_pair.hpp"

namespace creepcontact {
namespace {

using contact::ContactType;
using contact::MortarCoupling;
using mesh::CellType;

struct CurvedCase {
  std::string name;
  CellType slave, master;
  bool spherical, inner_is_slave;
};

class CurvedPair : public testing::TestWithParam<CurvedCase> {
 protected:
  static test::Part part(CellType type, std::array<int, 3> divisions, bool is_inner) {
    const test::Shell shell{
        .type = type, .divisions = divisions, .radius = is_inner ? 0.99 : 1.0, .is_inner = is_inner, .irregular = 0.3};
    return GetParam().spherical ? test::sphere(shell) : test::cylinder(shell);
  }
};

struct Resultant {
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  double sum = 0;  // of the nodal forces' magnitudes

  void add(const mesh::Mesh& mesh, const Eigen::VectorXd& forces) {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      const Vector3 f = forces.segment<3>(3 * i);
      force += f;
      moment += mesh.nodes[i].cross(f);
      sum += f.norm();
    }
  }
};

TEST_P(CurvedPair, ForcesBalanceInForceAndMoment) {
  const test::Part slave = part(GetParam().slave, {5, 3, 1}, GetParam().inner_is_slave);
  const test::Part master = part(GetParam().master, {4, 4, 1}, !GetParam().inner_is_slave);
  const MortarCoupling coupling = contact::mortar_coupling(slave.surface(), master.surface(), ContactType::unilateral);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int trial = 0; trial < 3; ++trial) {
    const Eigen::VectorXd lambda = Eigen::VectorXd::NullaryExpr(coupling.n_rows(), [&] { return value(generator); });
    Resultant both, alone;
    alone.add(slave.mesh, coupling.slave_rows.transpose() * lambda);
    both = alone;
    both.add(master.mesh, coupling.master_rows.transpose() * lambda);
    EXPECT_GT(alone.force.norm(), 1e-3 * alone.sum);
    EXPECT_LT(both.force.norm(), 1e-12 * both.sum);
    EXPECT_LT(both.moment.norm(), 1e-12 * both.sum);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, CurvedPair,
    testing::Values(CurvedCase{"hex8_cylinder", CellType::hex8, CellType::hex8, false, true},
                    CurvedCase{"hex20_cylinder", CellType::hex20, CellType::hex20, false, true},
                    CurvedCase{"hex20_cylinder_outer_slave", CellType::hex20, CellType::hex20, false, false},
                    CurvedCase{"tet10_on_hex27_cylinder", CellType::tet10, CellType::hex27, false, true},
                    CurvedCase{"tet4_on_hex8_cylinder", CellType::tet4, CellType::hex8, false, false},
                    CurvedCase{"wedge15_sphere", CellType::wedge15, CellType::hex20, true, true},
                    CurvedCase{"hex8_on_tet10_sphere", CellType::hex8, CellType::tet10, true, false},
                    CurvedCase{"tet4_sphere", CellType::tet4, CellType::tet4, true, true}),
    [](const auto& tested) { return tested.param.name; });

// A ring that turns on its shaft and shifts along it must feel nothing, however coarse and uneven the mesh.
TEST(SlidingMotions, AreFreeExactly) {
  const std::vector<mechanics::RigidMotion> sliding{{.rotation = Vector3::UnitY()}, {.translation = Vector3::UnitY()}};
  for (const CellType type : {CellType::hex20, CellType::tet10}) {
    const test::Part slave = test::cylinder({.type = type, .divisions = {3, 2, 1}, .radius = 0.995, .irregular = 0.4});
    const test::Part master = test::cylinder({.type = type, .divisions = {4, 3, 1}, .is_inner = false});
    const auto largest_gap = [&](std::span<const mechanics::RigidMotion> told) {
      const MortarCoupling coupling =
          contact::mortar_coupling(slave.surface(), master.surface(), ContactType::unilateral, told);
      double largest = 0;
      for (const mechanics::RigidMotion& motion : sliding) {
        const auto field = [&](const Vector3& x) { return motion.displacement(x); };
        largest = std::max(largest, (coupling.slave_rows * test::nodal(slave.mesh, field)).cwiseAbs().maxCoeff());
        largest = std::max(largest, (coupling.master_rows * test::nodal(master.mesh, field)).cwiseAbs().maxCoeff());
      }
      return largest;
    };
    EXPECT_LT(largest_gap(sliding), 1e-13) << mesh::name(type);
    EXPECT_GT(largest_gap({}), 1e-6) << mesh::name(type) << ": the mesh is too good to show anything";
  }
}

TEST(SlidingMotions, LeaveTheTranslationAcrossTheSurfaceAndPlaneRowsAlone) {
  const test::Part lower(test::box_mesh(CellType::hex20, {3, 2, 1}, Vector3::Ones(), {0, 0, -1}), "z1");
  const test::Part upper(test::box_mesh(CellType::tet10, {2, 2, 1}), "z0");
  // In the plane, about a point of the surface, linearly dependent, and across the surface: that one is passed over.
  const std::vector<mechanics::RigidMotion> sliding{{.translation = Vector3::UnitX()},
                                                    {.rotation = Vector3::UnitZ(), .centre = {0.5, 0.5, 0}},
                                                    {.translation = Vector3(1, 1, 0)},
                                                    {.translation = Vector3::UnitZ()}};
  const auto with = contact::mortar_coupling(lower.surface(), upper.surface(), ContactType::unilateral, sliding);
  const auto without = contact::mortar_coupling(lower.surface(), upper.surface(), ContactType::unilateral);
  EXPECT_LT((with.slave_rows - without.slave_rows).norm(), 1e-14);
  EXPECT_LT((with.master_rows - without.master_rows).norm(), 1e-14);
  EXPECT_NEAR(with.slave_rows.sum(), -1.0, 1e-13);
}

}  // namespace
}  // namespace creepcontact
