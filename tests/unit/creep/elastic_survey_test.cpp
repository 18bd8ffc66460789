#include "creepcontact/base/error.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

TEST(CreepRateUnits, ThatDoNotFitTogether) {
  const Case blocks;
  // young_modulus in Pa, everything else in MPa: stresses are a million times too large
  const config::Config pascals =
      blocks.config("", {"materials.soft.young_modulus=1e8", "materials.hard.young_modulus=2e8"});
  const std::string said = message_of<ModelError>([&] { const System system(pascals); });
  EXPECT_TRUE(says(said, {"body 'lower'", "e-24", "1e+06", "t = 0", "material 'soft'", "4e+23", "time.end",
                          "young_modulus", "\nbody 'upper'", "1e-24"}));
  // also where the load comes later
  const config::Config ramped = blocks.config(
      "",
      {"materials.soft.young_modulus=1e8", "materials.hard.young_modulus=2e8", "supports.3.displacement.z=-0.025*t"});
  EXPECT_TRUE(says(message_of<ModelError>([&] { const System system(ramped); }), {"t = 4", "material 'soft'"}));
}

TEST(CreepRateUnits, FastStartsAreNoMistake) {
  const Case blocks;
  // infinite at the start, and a hundred million times faster than the run is long
  EXPECT_NO_THROW(
      System(blocks.config("", {"materials.soft.creep=[{ law = 'strain_hardening', A = 1e-3, n = 4, m = 0.1 }]"})));
  EXPECT_NO_THROW(
      System(blocks.config("", {"materials.soft.creep=[{ law = 'kelvin_voigt', compliance = 1, time = 1e-15 }]"})));
  EXPECT_NO_THROW(System(blocks.config("", {"time.end=1e9"})));
}

}  // namespace
}  // namespace creepcontact::run::test
