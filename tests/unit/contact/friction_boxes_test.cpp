/// Contact with friction between meshed boxes.
#include <gtest/gtest.h>

#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

using contact::CondensedInterface;
using contact::ContactStatus;

constexpr double mu = 0.1;

/// A crowned joint between bodies of different stiffness, whose lateral strains differ: some nodes stick, some slip,
/// some are open.
std::unique_ptr<Boxes> joint(double dense_bytes, double friction) {
  const Function gap = Function::expression("0.02*((x - 0.3)^2 + y^2)", {"x", "y", "z", "t"});
  return std::make_unique<Boxes>(BoxSetup{.divisions = {7, 6, 3}, .young_modulus = 200},
                                 BoxSetup{.divisions = {5, 6, 3}, .young_modulus = 50}, true, Function(-0.012),
                                 contact::ContactType::unilateral, gap, dense_bytes, friction);
}

TEST(FrictionZone, AgreesWithTheDenseSolutionWithoutMatrices) {
  const auto dense = joint(CondensedInterface::unbounded, mu), large = joint(0.0, mu);
  ASSERT_FALSE(large->interface().is_dense());
  dense->solve(*contact::friction_solver(dense->interface().problem(), {}));
  const contact::ContactState& expected = dense->result.state;
  const double largest = expected.multiplier.maxCoeff();
  int n_of[3] = {0, 0, 0};
  for (const contact::NodeLinearization& node : expected.nodes) ++n_of[static_cast<int>(node.status)];
  for (const int n : n_of) EXPECT_GT(n, 3);
  for (const auto method : {settings::FrictionMethod::newton, settings::FrictionMethod::tresca}) {
    const contact::FrictionOptions options{method, {.max_iterations = 1000}};
    large->solve(*contact::friction_solver(large->interface().problem(), options));
    EXPECT_EQ(large->result.state.active, expected.active);
    EXPECT_LT((large->result.state.multiplier - expected.multiplier).cwiseAbs().maxCoeff(), 1e-7 * largest);
  }
}

TEST(FrictionZone, SmallFrictionApproachesNone) {
  const auto none = joint(CondensedInterface::unbounded, 0), little = joint(CondensedInterface::unbounded, 1e-9);
  none->solve(*contact::active_set_solver(none->interface().problem()));
  little->solve(*contact::friction_solver(little->interface().problem(), {}));
  const Eigen::VectorXd pressure = little->condensed().pairs[0].coupling.first_rows(little->result.state.multiplier);
  const Eigen::VectorXd& expected = none->result.state.multiplier;
  EXPECT_LT((pressure - expected).cwiseAbs().maxCoeff(), 1e-7 * expected.maxCoeff());
}

// A rigid motion of both bodies opens no gap and slides nowhere; forces on the two are equal and opposite. Along the
// normals of the planes of symmetry there are no rows.
TEST(FrictionZone, RowsAreOfRelativeDisplacement) {
  const auto boxes = joint(CondensedInterface::unbounded, mu);
  const contact::MortarCoupling& coupling = boxes->condensed().pairs[0].coupling;
  EXPECT_EQ(coupling.rows_per_node(), 3);
  Eigen::VectorXd lower(coupling.slave_rows.cols()), upper(coupling.master_rows.cols());
  const Vector3 shift(0.3, -0.7, 0.2);
  for (Index i = 0; i < lower.size(); ++i) lower[i] = shift[i % 3];
  for (Index i = 0; i < upper.size(); ++i) upper[i] = shift[i % 3];
  EXPECT_LT((coupling.slave_rows * lower + coupling.master_rows * upper).cwiseAbs().maxCoeff(), 1e-14);
  const Eigen::VectorXd moved = coupling.master_rows * upper;  // the upper body alone
  int n_held = 0;
  for (std::size_t i = 0; i < coupling.nodes.size(); ++i) {
    const Index row = coupling.row(i);
    EXPECT_NEAR(moved[row], coupling.area[i] * shift.dot(coupling.nodes[i].normal), 1e-14);
    for (const int k : {0, 1}) {
      const Vector3 &tangent = coupling.tangents[i][k], &x = boxes->bodies()[0].mesh().nodes[coupling.nodes[i].node];
      const bool is_held = (x.x() == 0 && std::abs(tangent.x()) == 1) || (x.y() == 0 && std::abs(tangent.y()) == 1);
      EXPECT_NEAR(moved[row + 1 + k], is_held ? 0 : coupling.area[i] * shift.dot(tangent), 1e-14);
      n_held += is_held ? 1 : 0;
      EXPECT_NEAR(coupling.tangents[i][k].dot(coupling.nodes[i].normal), 0, 1e-15);
    }
    EXPECT_NEAR(coupling.tangents[i][0].dot(coupling.tangents[i][1]), 0, 1e-15);
  }
  EXPECT_EQ(n_held, 8 + 7);
}

}  // namespace
}  // namespace creepcontact::test
