/// Values that would have no effect, or one that nobody asked for.

#include "config_fixture.hpp"

namespace creepcontact::config {
namespace {

TEST(SilentValues, ThermalExpansionFromNoTemperature) {
  const std::string heated = minimal + "[temperature]\nvalue = 500\n";
  expect_mistake(
      heated,
      {"--set materials.steel.thermal_expansion=1e-5: materials.steel.thermal_expansion: ", "'reference_temperature'"},
      {"materials.steel.thermal_expansion=1e-5"});
  EXPECT_TRUE(mistakes(heated, {"materials.steel.thermal_expansion=0"}).empty());
  EXPECT_TRUE(
      mistakes(heated, {"materials.steel.thermal_expansion=1e-5", "materials.steel.reference_temperature=0"}).empty());
  // no temperature, no thermal strain
  EXPECT_TRUE(mistakes(minimal, {"materials.steel.thermal_expansion=1e-5"}).empty());
}

TEST(SilentValues, AxisOfAProbe) {
  const std::string probe = minimal + "[[probes]]\nname = \"a\"\non = \"s\"\n";
  expect_mistake(probe + "quantity = \"stress_xx\"\naxis = [0, 1, 0]\n",
                 {"cases/block.toml:16:8: probes[0].axis: ", "'stress_xx'", "stress_theta"});
  expect_mistake(probe + "quantity = \"von_mises\"\norigin = [0, 1, 0]\n",
                 {"cases/block.toml:16:10: probes[0].origin: ", "'von_mises'"});
  expect_mistake(probe + "quantity = \"stress_theta\"\naxis = [0, 0, 0]\n",
                 {"cases/block.toml:16:8: probes[0].axis: ", "[0, 0, 0]"});
  const Config config = parse_text(probe + "quantity = \"stress_theta\"\naxis = [0, 2, 0]\norigin = [1, 2, 3]\n");
  EXPECT_EQ(config.probes[0].axis, (std::array<double, 3>{0, 2, 0}));
  EXPECT_EQ(config.probes[0].origin, (std::array<double, 3>{1, 2, 3}));
}

TEST(SilentValues, GapOfATiedContact) {
  const std::string tied = minimal + "[[contacts]]\nbetween = [\"a\", \"b\"]\ntype = \"tied\"\n";
  for (const char* gap : {"-0.05", "\"geometric\"", "\"0.1*t\""})
    expect_mistake(tied + "gap = " + gap + '\n', {"cases/block.toml:15:7: contacts[0].gap: ", "tied"});
  EXPECT_TRUE(mistakes(tied + "gap = 0\n").empty());
}

}  // namespace
}  // namespace creepcontact::config
