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
  EXPECT_TRUE(said.starts_with("body 'lower' would relax ")) << said;
  EXPECT_TRUE(contains(said,
                       "e-24 of the run time: under its typical stress of 1e+06 at t = 0, material 'soft' creeps by "
                       "4e+23 times its elastic strain until time.end; check that young_modulus, the loads and the "
                       "creep constants are in the same units\nbody 'upper' would relax within 1e-24 of the run time"))
      << said;
  // also where the load comes later
  const config::Config ramped = blocks.config(
      "",
      {"materials.soft.young_modulus=1e8", "materials.hard.young_modulus=2e8", "supports.3.displacement.z=-0.025*t"});
  EXPECT_TRUE(contains(message_of<ModelError>([&] { const System system(ramped); }), "at t = 4, material 'soft'"));
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
