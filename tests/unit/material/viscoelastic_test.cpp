// Numbers of linear viscoelastic creep.
#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/material/hereditary.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace viscoelastic_tests {
namespace {

std::vector<double> values_of(const CreepLaw& law) {
  std::vector<double> values;
  for (const Function& parameter : law.parameters()) values.push_back(parameter({.T = 20}));
  return values;
}

/// Creep strain after a time under constant stress, from the virgin state.
Tensor6 creep(const CreepLaw& law, const Tensor6& stress, double time) {
  const std::vector<double> parameters = values_of(law);
  std::vector<double> own(law.n_internal(), 0.0);
  const std::vector<double> virgin = own;
  Tensor6 strain = Tensor6::Zero();
  law.increment({.stress = tensor::view(stress), .internal = virgin, .parameters = parameters}, time,
                {tensor::writable(strain), own});
  return strain;
}

std::unique_ptr<CreepLaw> named(const std::string& name, ParameterValues values) {
  return make_law(name, std::move(values));
}

const Tensor6 uniaxial = (Tensor6() << 10, 0, 0, 0, 0, 0).finished();

TEST(Hereditary, UniaxialCreepFollowsThePronySeries) {
  const Hereditary law("hereditary", {{1e-4, 3e-4}, {2.0, 50.0}, {}, {1e-6}});
  for (const double t : {0.1, 3.0, 80.0}) {
    const double expected = 10 * (1e-4 * (1 - std::exp(-t / 2)) + 3e-4 * (1 - std::exp(-t / 50)) + 1e-6 * t);
    const Tensor6 strain = creep(law, uniaxial, t);
    EXPECT_NEAR(strain[0], expected, 1e-14 * expected + 1e-17);
    EXPECT_NEAR(strain[1], -expected / 2, 1e-14 * expected + 1e-17);
  }
}

TEST(Hereditary, VolumeCreepsUnderTheMeanStress) {
  const Hereditary law("hereditary", {{1e-4}, {2.0}, {6e-5}, {0.0}});
  const Tensor6 strain = creep(law, -30.0 * tensor::identity(), 1.0);
  EXPECT_NEAR(tensor::trace(strain), -30 * 6e-5 * (1 - std::exp(-0.5)), 1e-17);
  EXPECT_LT(tensor::deviator(strain).norm(), 1e-17);
  // Axial strain: deviatoric part J sigma, volumetric part B (sigma/3)/3.
  EXPECT_NEAR(creep(law, uniaxial, 1e9)[0], 10 * (1e-4 + 6e-5 / 9), 1e-16);
}

TEST(Hereditary, TheIncrementSolvesTheRateEquation) {
  const Hereditary law("hereditary", {{1e-4}, {2.0}, {6e-5}, {1e-5}});
  const std::vector<double> parameters = values_of(law);
  Tensor6 own = Tensor6::Zero(), strain = Tensor6::Zero();
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    Tensor6 rate = Tensor6::Zero(), own_rate;
    law.rate({.stress = tensor::view(uniaxial), .internal = {own.data(), 6}, .parameters = parameters},
             {tensor::writable(rate), {own_rate.data(), 6}});
    own += 3.0 / n * own_rate;
    strain += 3.0 / n * rate;
  }
  const Tensor6 exact = creep(law, uniaxial, 3.0);
  EXPECT_LT((strain - exact).norm(), 1e-5 * exact.norm());
}

TEST(Hereditary, SpecialCasesAreTheSameLaw) {
  const Hereditary burgers("", {{2e-4}, {5.0}, {}, {1 / 4e5}}), kelvin("", {{2e-4}, {5.0}, {}, {0.0}});
  const Tensor6 stress = (Tensor6() << 10, -5, 3, 2, 7, -1).finished();
  EXPECT_LT((creep(*named("burgers", {{4e5}, {2e-4}, {5.0}}), stress, 7) - creep(burgers, stress, 7)).norm(), 1e-18);
  EXPECT_LT((creep(*named("kelvin_voigt", {{2e-4}, {5.0}}), stress, 7) - creep(kelvin, stress, 7)).norm(), 1e-18);
  const auto maxwell = named("maxwell", {{4e5}});
  EXPECT_EQ(maxwell->n_internal(), 0);
  EXPECT_NEAR(creep(*maxwell, uniaxial, 7)[0], 10 / 4e5 * 7, 1e-18);
}

TEST(Hereditary, ViscosityMayDependOnTheTemperature) {
  const auto maxwell = named("maxwell", {{Function::expression("1e5*exp(20/T)", {"T"})}});
  const Function& fluidity = maxwell->parameters()[0];
  EXPECT_TRUE(fluidity.depends_on_temperature());
  EXPECT_NEAR(fluidity({.T = 20}), 1e-5 / std::exp(1.0), 1e-19);
  EXPECT_EQ(fluidity.text(), "1/(1e5*exp(20/T))");
}

TEST(Hereditary, ListsThatDifferAreNamed) {
  try {
    Hereditary("hereditary", {{1e-4, 2e-4}, {2.0, 3.0}, {1e-5}, {0.0}});
    FAIL() << "accepted";
  } catch (const ParameterError& error) {
    EXPECT_EQ(error.key(), "volumetric_compliances");
  }
  EXPECT_THROW(Hereditary("hereditary", {{1e-4}, {}, {}, {0.0}}), ParameterError);
  EXPECT_THROW(Hereditary("hereditary", {{}, {}, {1e-5}, {0.0}}), ParameterError);
}

}  // namespace
}  // namespace viscoelastic_tests
}  // namespace creepcontact::material
