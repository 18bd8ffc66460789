/// Contact zones that are not condensed to dense matrices.
#include <gtest/gtest.h>

#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

using contact::CondensedInterface;
using contact::ContactType;

struct ZoneCase {
  std::string name;
  CellType type;
  double upper_modulus;
  bool lower_is_slave;
  ContactType contact;
};

class LargeZone : public testing::TestWithParam<ZoneCase> {
 protected:
  static std::unique_ptr<Boxes> assembly(double dense_bytes) {
    const ZoneCase& zone = GetParam();
    // A crowned joint: part of it stays open.
    const Function gap = Function::expression("0.02*((x - 0.3)^2 + y^2)", {"x", "y", "z", "t"});
    return std::make_unique<Boxes>(
        BoxSetup{.type = zone.type, .divisions = {4, 3, 2}, .young_modulus = 200},
        BoxSetup{.type = zone.type, .divisions = {3, 4, 2}, .young_modulus = zone.upper_modulus}, zone.lower_is_slave,
        Function(-0.004), zone.contact, gap, dense_bytes);
  }
};

TEST_P(LargeZone, AgreesWithTheDenseSolution) {
  const auto dense = assembly(CondensedInterface::unbounded), large = assembly(0.0);
  ASSERT_TRUE(dense->interface().is_dense());
  ASSERT_FALSE(large->interface().is_dense());
  EXPECT_GT(dense->interface().dense_bytes(), 0);
  dense->solve(*contact::active_set_solver(dense->interface().problem()));
  const Eigen::VectorXd& expected = dense->result.state.multiplier;
  const double largest = expected.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd& flexibility = dense->interface().problem().total;
  if (GetParam().contact == ContactType::unilateral) {
    EXPECT_LT(dense->result.state.active.size(), static_cast<std::size_t>(expected.size())) << "part of it is open";
  }
  for (const bool schwarz : {true, false}) {
    const contact::ContactProblem& problem = large->interface().problem();
    const auto solver =
        schwarz ? contact::schwarz_solver(problem, {.max_iterations = 1000}) : contact::active_set_solver(problem);
    large->solve(*solver);
    EXPECT_EQ(large->result.state.active, dense->result.state.active);
    // Multipliers of tied rows that the supports hold nearly are nearly undetermined: measured by what they move.
    const Eigen::VectorXd moved = flexibility * (large->result.state.multiplier - expected);
    EXPECT_LT(moved.cwiseAbs().maxCoeff(), 1e-8 * flexibility.diagonal().maxCoeff() * largest);
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t i = 0; i < dense->stress[b].size(); ++i)
        EXPECT_NEAR(large->stress[b][i], dense->stress[b][i], 1e-7 * largest);
  }
  EXPECT_LT(large->interface().flexibility().n_products(), 2 * 60) << "passes through the factors";
}

INSTANTIATE_TEST_SUITE_P(Zones, LargeZone,
                         testing::Values(ZoneCase{"hex8", CellType::hex8, 200, true, ContactType::unilateral},
                                         ZoneCase{"hex20", CellType::hex20, 2000, true, ContactType::unilateral},
                                         ZoneCase{"tet10", CellType::tet10, 20, false, ContactType::unilateral},
                                         ZoneCase{"tied", CellType::hex8, 200, false, ContactType::tied}),
                         [](const auto& zone) { return zone.param.name; });

}  // namespace
}  // namespace creepcontact::test
