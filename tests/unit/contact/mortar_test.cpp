#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "support/contact/boxes.hpp"
#include "support/says.hpp"

namespace creepcontact {
namespace {

using contact::ContactType;
using mesh::CellType;

struct PatchCase {
  CellType lower, upper;
  bool lower_is_slave;
};

std::string name_of(const testing::TestParamInfo<PatchCase>& info) {
  return std::string(mesh::name(info.param.lower)) + "_" + std::string(mesh::name(info.param.upper)) +
         (info.param.lower_is_slave ? "_lower_slave" : "_upper_slave");
}

class ContactPatch : public testing::TestWithParam<PatchCase> {};

std::vector<PatchCase> patch_cases() {
  std::vector<PatchCase> cases;
  for (const CellType type : {CellType::tet4, CellType::tet10, CellType::hex8, CellType::hex20, CellType::hex27,
                              CellType::wedge6, CellType::wedge15})
    for (const bool lower : {true, false}) cases.push_back({type, type, lower});
  cases.push_back({CellType::hex20, CellType::tet10, true});
  cases.push_back({CellType::hex8, CellType::tet4, false});
  return cases;
}

// Two boxes of equal modulus squeezed by 0.02: uniaxial stress E * 0.02 / 2 on any pair of meshes.
TEST_P(ContactPatch, TransmitsUniformPressureOnNonMatchingMeshes) {
  test::Boxes assembly({.type = GetParam().lower, .divisions = {3, 2, 2}},
                       {.type = GetParam().upper, .divisions = {2, 3, 2}}, GetParam().lower_is_slave, -0.02);
  const auto solver = contact::active_set_solver(assembly.interface().problem());
  assembly.solve(*solver);
  const double pressure = 200.0 * 0.02 / 2;
  const contact::MortarCoupling& coupling = assembly.interface().pairs()[0].coupling;
  double resultant = 0;
  for (int i = 0; i < coupling.n_rows(); ++i) {
    EXPECT_NEAR(assembly.result.state.multiplier[i], pressure, 1e-8 * pressure);
    resultant += coupling.area[i] * assembly.result.state.multiplier[i];
  }
  EXPECT_NEAR(resultant, pressure, 1e-9 * pressure);
  for (const auto& stress : assembly.stress)
    for (std::size_t p = 0; p < stress.size(); p += 6) {
      EXPECT_NEAR(stress[p + 2], -pressure, 1e-8 * pressure);
      EXPECT_NEAR(stress[p], 0, 1e-8 * pressure);
      EXPECT_NEAR(stress[p + 5], 0, 1e-8 * pressure);
    }
}

INSTANTIATE_TEST_SUITE_P(AllElements, ContactPatch, testing::ValuesIn(patch_cases()), name_of);

TEST(Mortar, ForcesAreEqualOppositeAndMomentFree) {
  const test::Boxes assembly({.type = CellType::hex20, .divisions = {3, 2, 1}},
                             {.type = CellType::tet10, .divisions = {2, 2, 1}}, true, 0.0);
  const contact::MortarCoupling& coupling = assembly.interface().pairs()[0].coupling;
  const Eigen::VectorXd multiplier = Eigen::VectorXd::LinSpaced(coupling.n_rows(), 1.0, 2.0);
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  for (std::size_t b = 0; b < 2; ++b) {
    std::vector<double> forces(3 * assembly.bodies()[b].mesh().nodes.size(), 0.0);
    assembly.interface().rows().add_contact_forces(b, multiplier, forces);
    Vector3 own = Vector3::Zero();
    for (std::size_t i = 0; i < forces.size() / 3; ++i) {
      const Vector3 f(forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]);
      own += f;
      moment += assembly.bodies()[b].mesh().nodes[i].cross(f);
    }
    EXPECT_GT(std::abs(own.z()), 1.0);
    EXPECT_LT(own.z() * (b == 0 ? 1 : -1), 0) << "contact pushes the lower box down, the upper one up";
    force += own;
  }
  EXPECT_LT(force.norm(), 1e-13);
  EXPECT_LT(moment.norm(), 1e-13);
}

TEST(Mortar, DualHatsMakeTheSlaveMatrixDiagonalAtCorners) {
  const test::Boxes assembly({.divisions = {3, 2, 1}}, {.divisions = {2, 3, 1}}, true, 0.0);
  const contact::MortarCoupling& coupling = assembly.interface().pairs()[0].coupling;
  double area = 0;
  for (int i = 0; i < coupling.n_rows(); ++i) {
    area += coupling.area[i];
    for (contact::RowMatrix::InnerIterator it(coupling.slave_rows, i); it; ++it) {
      const bool own = it.col() == 3 * coupling.nodes[i].node + 2;
      EXPECT_NEAR(it.value(), own ? -coupling.area[i] : 0.0, 1e-14);
    }
  }
  EXPECT_NEAR(area, 1.0, 1e-13);
}

// The upper box covers only part of the lower one: rows that are hardly covered join their neighbours.
TEST(Mortar, PatchTestHoldsWhereTheSlaveSticksOut) {
  for (const double covered : {0.505, 0.6, 0.97}) {
    const test::Boxes assembly({.divisions = {4, 4, 1}, .lengths = {1, 1, 1}},
                               {.divisions = {2, 3, 1}, .lengths = {covered, 1, 1}}, true, 0.0);
    const contact::MortarCoupling& coupling = assembly.interface().pairs()[0].coupling;
    // A linear displacement of the master: its weighted gaps are those of a rigid slave under it.
    const auto& master = assembly.bodies()[1].mesh();
    Eigen::VectorXd u(3 * master.nodes.size());
    for (std::size_t i = 0; i < master.nodes.size(); ++i) u.segment<3>(3 * i) << 0, 0, 1.0;
    const Eigen::VectorXd gap = coupling.master_rows * u;
    double sum = 0;
    for (int i = 0; i < coupling.n_rows(); ++i) {
      EXPECT_NEAR(gap[i], coupling.area[i], 1e-12);
      sum += gap[i];
    }
    EXPECT_NEAR(sum, covered, 1e-10);
  }
}

TEST(Mortar, GapIsGivenAsFunctionOfPlaceAndTime) {
  const test::Boxes assembly({.divisions = {3, 2, 1}}, {.divisions = {2, 3, 1}}, true, 0.0);
  const contact::MortarCoupling& coupling = assembly.interface().pairs()[0].coupling;
  const Eigen::VectorXd constant = coupling.given_gap(Function::expression("0.5*t", {"t"}), 2.0);
  const Eigen::VectorXd linear = coupling.given_gap(Function::expression("x*t", {"x", "t"}), 3.0);
  EXPECT_NEAR(constant.sum(), 1.0, 1e-12);
  EXPECT_NEAR(linear.sum(), 1.5, 1e-12);
  EXPECT_NEAR(coupling.geometric_gap.cwiseAbs().maxCoeff(), 0.0, 1e-13);
}

TEST(Mortar, SurfacesThatDoNotFaceEachOtherAreAnError) {
  const test::Boxes assembly({}, {}, true, 0.0);
  EXPECT_TRUE(test::says(test::message_of<ModelError>([&] {
                           contact::mortar_coupling(assembly.surface(assembly.bodies()[0], "z0"),
                                                    assembly.surface(assembly.bodies()[1], "z0"),
                                                    ContactType::unilateral);
                         }),
                         {"contact between '", "' and '", "face"}));
}

TEST(Mortar, CoarserSurfaceIsTheBetterSlaveAndSofterWinsOverBoth) {
  const test::Boxes assembly({.divisions = {4, 4, 1}}, {.divisions = {2, 2, 1}}, true, 0.0);
  contact::Surface fine = assembly.surface(assembly.bodies()[0], "z1"),
                   coarse = assembly.surface(assembly.bodies()[1], "z0");
  EXPECT_FALSE(contact::first_is_better_slave(fine, coarse));
  EXPECT_TRUE(contact::first_is_better_slave(coarse, fine));
  coarse.young_modulus = 100;
  EXPECT_TRUE(contact::first_is_better_slave(fine, coarse));
}

TEST(Mortar, HeldSurfaceIsNoSlave) {
  const test::Boxes assembly({.divisions = {2, 2, 1}}, {.divisions = {4, 4, 1}}, true, 0.0);
  const contact::Surface held = assembly.surface(assembly.bodies()[0], "z0"),
                         movable = assembly.surface(assembly.bodies()[1], "z0");
  EXPECT_FALSE(contact::first_is_better_slave(held, movable)) << "though it is coarser";
  EXPECT_TRUE(contact::first_is_better_slave(movable, held));
}

/// Rows that join others leave their part of every rigid motion, and of the area, to them.
TEST(Mortar, RowsThatJoinOthers) {
  const test::Boxes assembly({.divisions = {3, 3, 1}}, {.divisions = {2, 2, 1}}, true, 0.0);
  contact::Surface slave = assembly.surface(assembly.bodies()[0], "z1");
  const contact::Surface master = assembly.surface(assembly.bodies()[1], "z0");
  const auto all = contact::mortar_coupling(slave, master, ContactType::unilateral);
  const std::set<std::int64_t> border = mesh::border_nodes(slave.faces);
  EXPECT_EQ(border.size(), 12U);
  slave.joining = {border.begin(), border.end()};
  const auto inner = contact::mortar_coupling(slave, master, ContactType::unilateral);
  EXPECT_EQ(inner.nodes.size(), 4U);
  for (const contact::MultiplierNode& at : inner.nodes) EXPECT_FALSE(border.contains(at.node));
  const Eigen::VectorXd force = Eigen::VectorXd::Ones(all.n_rows());
  EXPECT_LT((all.slave_rows.transpose() * force - inner.slave_rows.transpose() * force.head(inner.n_rows())).norm(),
            1e-14);
  EXPECT_LT((all.master_rows.transpose() * force - inner.master_rows.transpose() * force.head(inner.n_rows())).norm(),
            1e-14);
}

/// A foot so small on a large face that it covers no multiplier of that face by a tenth.
TEST(Mortar, SmallFootOnALargeFace) {
  const test::Boxes assembly({.divisions = {1, 1, 1}, .distortion = 0},
                             {.divisions = {2, 2, 1}, .lengths = {0.2, 0.2, 0.1}, .distortion = 0}, false, 0.0);
  const contact::Surface floor = assembly.surface(assembly.bodies()[0], "z1"),
                         foot = assembly.surface(assembly.bodies()[1], "z0");
  EXPECT_TRUE(contact::first_is_better_slave(foot, floor)) << "though it is finer";
  for (const auto& coupling : {contact::mortar_coupling(floor, foot, ContactType::unilateral),
                               contact::mortar_coupling(foot, floor, ContactType::unilateral)}) {
    double area = 0;
    for (const double one : coupling.area) area += one;
    EXPECT_NEAR(area, 0.04, 1e-12);
    // Unit pressure presses both with the force of the foot's area.
    const Eigen::VectorXd forces = coupling.slave_rows.transpose() * Eigen::VectorXd::Ones(coupling.n_rows());
    double sum = 0;
    for (Index i = 2; i < forces.size(); i += 3) sum += forces[i];
    EXPECT_NEAR(std::abs(sum), 0.04, 1e-12);
  }
}

TEST(Mortar, TiedBoxesCarryTension) {
  test::Boxes assembly({.type = CellType::hex20, .divisions = {3, 2, 1}}, {.divisions = {2, 3, 2}}, true, 0.02,
                       ContactType::tied);
  const auto solver = contact::schwarz_solver(assembly.interface().problem(), {});
  assembly.solve(*solver);
  for (const auto& stress : assembly.stress)
    for (std::size_t p = 0; p < stress.size(); p += 6) EXPECT_NEAR(stress[p + 2], 2.0, 1e-7);
}

TEST(Mortar, BodiesOpenWhenPulledAndCloseWhenPushed) {
  test::Boxes assembly({.divisions = {2, 2, 2}}, {.divisions = {3, 3, 2}}, false,
                       Function::expression("0.01*cos(t)", {"t"}));
  const auto solver = contact::schwarz_solver(assembly.interface().problem(), {});
  assembly.solve(*solver, 0.0);
  EXPECT_TRUE(assembly.result.state.active.empty());
  EXPECT_EQ(assembly.result.state.multiplier.norm(), 0.0);
  EXPECT_NEAR(assembly.result.gap.sum(), 0.01, 1e-12);
  assembly.solve(*solver, 3.14159265358979);
  EXPECT_NEAR(assembly.result.state.multiplier.minCoeff(), 1.0, 1e-9);
  EXPECT_LT(assembly.result.gap.cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace creepcontact
