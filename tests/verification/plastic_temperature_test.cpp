/// Bars at constant strain whose yield stress, modulus and hardening change with temperature: without any change of the
/// load they flow while they are heated, and are elastic while they cool.

#include <fmt/format.h>

#include <algorithm>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/cube.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_temperature_tests {
namespace {

using namespace test;

/// Heated from 0 to 100, cooled, and heated twice as fast to 120.
const std::string heated = "{ t = [0, 1, 2, 2.6], values = [0, 100, 0, 120] }";

/// @param material  keys, with `young_modulus` @param strain  along x, held
Table run_bar(const std::string& material, double strain, const std::string& temperature = heated) {
  const std::string inside = "body = \"cube\"";
  return run_case(
             "[mesh]\nfile = \"case.geo\"\norder = 1\n[bodies.cube]\nregion = \"cube\"\nmaterial = \"alloy\"\n"
             "[materials.alloy]\npoisson_ratio = 0.3\n" +
                 material + "\n[temperature]\nvalue = " + temperature +
                 "\n[time]\nend = 2.6\ntolerance = 1e-6\noutput = [0.1, 0.5, 1, 1.5, 2, 2.3]\n" + support("x0", "x") +
                 support("y0", "y") + support("z0", "z") + support("x1", "x", fmt::format("{}", 100 * strain)) +
                 probe("stress", "stress_xx", inside) + probe("flow", "plastic_strain_xx", inside),
             cube_geo)
      .history;
}

TEST(HeatedPlasticBar, HasTheYieldStressOfItsTemperature) {
  const Table bar = run_bar(
      "young_modulus = 1000\nplasticity = { yield_stress = { T = [0, 100, 120], values = [1, 0.5, 0.3] } }", 9e-4);
  EXPECT_NEAR(bar.at("stress", 0), 0.9, 1e-9);
  EXPECT_NEAR(bar.at("stress", 0.1), 0.9, 1e-9) << "at 10 degrees it carries 0.95";
  EXPECT_NEAR(bar.at("stress", 0.5), 0.75, 1e-7);
  EXPECT_NEAR(bar.at("stress", 1), 0.5, 1e-7);
  EXPECT_NEAR(bar.at("flow", 1), 4e-4, 1e-10);
  for (const double t : {1.5, 2.0, 2.3}) {
    EXPECT_NEAR(bar.at("stress", t), 0.5, 1e-7) << "cooling, and heating below the temperature of before";
    EXPECT_NEAR(bar.at("flow", t), 4e-4, 1e-10);
  }
  EXPECT_NEAR(bar.at("stress", 2.6), 0.3, 1e-7);
}

/// E = 1000 - 2 T too: where it is elastic, the stress is E times the elastic strain.
TEST(HeatedPlasticBar, FollowsItsModulusWhereItIsElastic) {
  const auto E = [](double T) { return 1000 - 2 * T; };
  const auto yield = [](double T) { return 1 - 0.006 * T; };
  const Table bar = run_bar("young_modulus = \"1000 - 2*T\"\nplasticity = { yield_stress = \"1 - 0.006*T\" }", 9e-4);
  EXPECT_NEAR(bar.at("stress", 0.1), 0.9e-3 * E(10), 1e-8);
  EXPECT_NEAR(bar.at("stress", 0.5), yield(50), 1e-7);
  EXPECT_NEAR(bar.at("stress", 1), yield(100), 1e-7);
  const double kept = yield(100) / E(100);
  EXPECT_NEAR(bar.at("flow", 1), 9e-4 - kept, 1e-10);
  EXPECT_NEAR(bar.at("stress", 1.5), kept * E(50), 1e-7);
  EXPECT_NEAR(bar.at("stress", 2), kept * E(0), 1e-7);
  EXPECT_NEAR(bar.at("stress", 2.6), yield(120), 1e-7);
}

/// Hardening 200 - T: isotropic as a table, and as a back stress, which changes with its modulus while nothing flows.
TEST(HeatedPlasticBar, HardensByTheModulusOfItsTemperature) {
  const auto yield = [](double T) { return 1 - 0.005 * T; };
  const auto H = [](double T) { return 200 - T; };
  // sigma = E (eps - p) = sy(T) + H(T) p
  const double strain = 1.2e-3;
  const auto flow = [&](double T) { return (1000 * strain - yield(T)) / (1000 + H(T)); };
  for (const char* law :
       {"hardening_modulus = \"200 - T\", yield_stress = \"1 - 0.005*T\"",
        "kinematic = [{ C = \"200 - T\", gamma = 0 }], yield_stress = \"1 - 0.005*T\"",
        "curve = [{ T = 0, plastic_strain = [0, 0.01], stress = [1, 3] }, { T = 120, plastic_strain = [0, 0.01], "
        "stress = [0.4, 1.2] }]"}) {
    const Table bar = run_bar(fmt::format("young_modulus = 1000\nplasticity = {{ {} }}", law), strain);
    for (const auto& [t, T] : {std::pair{0.0, 0.0}, {0.1, 10.0}, {0.5, 50.0}, {1.0, 100.0}, {2.6, 120.0}})
      EXPECT_NEAR(bar.at("flow", t), flow(T), 1e-9) << t << ' ' << law;
    for (const double t : {1.5, 2.0, 2.3}) EXPECT_NEAR(bar.at("flow", t), flow(100), 1e-9) << t << ' ' << law;
  }
}

/// Held at its ends, a bar that is heated by more than its yield stress allows is in tension when it is cold again.
TEST(HeatedPlasticBar, IsInTensionWhenColdAgain) {
  const Table bar = run_bar(
      "young_modulus = 1000\nthermal_expansion = 2e-5\nreference_temperature = 0\n"
      "plasticity = { yield_stress = { T = [0, 120], values = [1, 0.4] } }",
      0, "{ t = [0, 1, 2, 2.6], values = [0, 100, 0, 100] }");
  const double hot = 0.5;
  EXPECT_NEAR(bar.at("stress", 0.1), -0.2, 1e-9);
  EXPECT_NEAR(bar.at("stress", 1), -hot, 1e-7);
  EXPECT_NEAR(bar.at("flow", 1), -(2 - hot) / 1000, 1e-10);
  // Cooling by 100 pulls by 2: up to yielding, at a temperature T where -0.5 + 2 (1 - T/100) = 1 - T/200.
  EXPECT_NEAR(bar.at("stress", 1.5), 0.5, 1e-7) << "elastic";
  EXPECT_NEAR(bar.at("stress", 2), 1, 1e-7);
  EXPECT_NEAR(bar.at("flow", 2), -1e-3, 1e-10) << "0.5 of the stress has flowed back";
  EXPECT_NEAR(bar.at("stress", 2.6), -hot, 1e-7);
  EXPECT_NEAR(bar.at("flow", 2.6), -(2 - hot) / 1000, 1e-10) << "reverse plasticity: the same each time";
}

}  // namespace
}  // namespace plastic_temperature_tests
}  // namespace creepcontact
