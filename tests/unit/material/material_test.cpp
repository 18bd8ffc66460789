#include "creepcontact/material/material.hpp"

#include <gtest/gtest.h>

#include "../../../src/material/norton.hpp"

namespace creepcontact::material {
namespace {

TEST(Material, UniaxialStressHasYoungsModulusAndPoissonsRatio) {
  const double E = 2.06e5, nu = 0.3, strain = 1e-3;
  const Tensor6 e = (Tensor6() << strain, -nu * strain, -nu * strain, 0, 0, 0).finished();
  const Tensor6 sigma = stress(lame(E, nu), e);
  EXPECT_NEAR(sigma[0], E * strain, 1e-10 * E * strain);
  EXPECT_LT(sigma.tail<5>().norm(), 1e-12 * E);
}

TEST(Material, ShearStressIsTwiceTheShearModulusTimesTheTensorComponent) {
  const Tensor6 e = (Tensor6() << 0, 0, 0, tensor::sqrt2 * 1e-3, 0, 0).finished();
  EXPECT_NEAR(tensor::to_matrix(stress(lame(2.6e5, 0.3), e))(0, 1), 2 * 1e5 * 1e-3, 1e-9);
}

TEST(Material, VolumeChangesByTheBulkModulus) {
  const double E = 1.8e5, nu = 0.35;
  const Tensor6 e = 1e-4 * tensor::identity();
  EXPECT_NEAR(stress(lame(E, nu), e)[0], E / (1 - 2 * nu) * 1e-4, 1e-10);
}

/// Two internal variables and no rate: only the size matters here.
class TwoVariables final : public CreepLaw {
 public:
  TwoVariables() : CreepLaw({}) {}
  std::string name() const override { return "two_variables"; }
  int n_internal() const override { return 2; }
  void rate(const PointState&, PointRate) const override {}
  void derivative(const PointState&, const PointChange&, PointRate) const override {}
  StressTangent stress_tangent(const PointState&) const override { return {}; }
};

TEST(Material, StateIsTheCreepStrainAndTheLawsOwnVariables) {
  Material m;
  EXPECT_FALSE(m.creeps());
  EXPECT_EQ(m.n_state(), 0);
  m.creep.push_back(std::make_shared<Norton>(ParameterValues{{1e-20}, {7.0}}));
  EXPECT_TRUE(m.creeps());
  EXPECT_EQ(m.n_state(), 6);
  m.creep.push_back(std::make_shared<TwoVariables>());
  EXPECT_EQ(m.n_state(), 8);
}

}  // namespace
}  // namespace creepcontact::material
