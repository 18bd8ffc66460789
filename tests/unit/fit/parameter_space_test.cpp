// Unknowns of a fit: what they mean at the reference temperature.
#include "../../../src/fit/parameter_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "creepcontact/material/bar.hpp"

namespace creepcontact::fit {
namespace {

constexpr double cold = 500, hot = 560, zero = -273.15;

TestData tests_at_two_temperatures() {
  TestData data{.file = "synthetic", .units = {}, .has_temperature = true, .tests = {}, .notes = {}};
  for (const double temperature : {cold, hot})
    for (const double stress : {80.0, 120.0})
      data.tests.push_back({.name = "test",
                            .kind = TestKind::creep,
                            .stress = stress,
                            .temperature = temperature,
                            .readings = {{.time = 10, .value = 1e-3}, {.time = 1000, .value = 1e-2}}});
  return data;
}

// An activation energy turns the law about the reference temperature: there its strains do not depend on the unknown of
// the energy, whether the energy acts on a rate, on a time or on a viscosity.
class ParameterSpaceOf : public testing::TestWithParam<const char*> {};

TEST_P(ParameterSpaceOf, AnEnergyTurnsTheLawAboutTheReferenceTemperature) {
  const TestData data = tests_at_two_temperatures();
  const LawChoice choice = choose_law({.law = GetParam()}, data);
  const ParameterSpace space(choice, data);
  Eigen::Index energy = -1;
  for (std::size_t i = 0; i < space.size(); ++i)
    if (space.parameter(i).key == "activation_energy") energy = static_cast<Eigen::Index>(i);
  ASSERT_GE(energy, 0);
  const double reference = zero + 2 / (1 / (cold - zero) + 1 / (hot - zero));
  const auto strain = [&](double x_of_energy, double temperature) {
    Eigen::VectorXd x = 0.5 * (space.lowest_guess(1e-2) + space.highest_guess());
    x[energy] = x_of_energy;
    const std::vector<std::shared_ptr<const material::CreepLaw>> laws{space.law(x)};
    const std::vector<double> times{3};
    return material::bar_history(laws, {.stress = 100, .temperature = temperature}, times).last.creep_strain;
  };
  const double low = std::log(20.0), high = std::log(50.0);
  EXPECT_NEAR(strain(high, reference) / strain(low, reference), 1, 1e-6);
  EXPECT_GT(strain(high, hot), 1.01 * strain(low, hot));
}

INSTANTIATE_TEST_SUITE_P(Laws, ParameterSpaceOf,
                         testing::Values("norton", "strain_hardening", "maxwell", "kelvin_voigt", "burgers"));

}  // namespace
}  // namespace creepcontact::fit
