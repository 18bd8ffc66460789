/// Runs whose strains or rotations are not small say so once, with the largest value of the run and its place.

#include <fstream>
#include <sstream>

#include "creepcontact/run/check.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace small_strain_tests {
namespace {

std::vector<std::string> texts_of(const Case& blocks, const std::vector<std::string>& overrides) {
  std::vector<std::string> with = overrides;
  with.emplace_back("output.fields=false");
  const Summary result = run(blocks.config("", with), {.output = (blocks / "out").string()});
  EXPECT_EQ(result.exit_status, 0) << result.message;
  std::vector<std::string> found;
  for (const std::string& warning : SummaryFile(blocks / "out/summary.json").texts("warnings"))
    if (contains(warning, "not small")) found.push_back(warning);
  return found;
}

const std::string pressed = "loads=[{ on = 'top', pressure = 'min(t, 1)' }]";
/// Without the support of the top.
const std::string free_top = "supports.3.on='bottom'", zero = "supports.3.displacement.z=0";

TEST(SmallStrain, ElasticStrainAboveFivePercent) {
  const Case blocks;
  const auto of = [&](double modulus) {
    return texts_of(blocks, elastic({pressed, free_top, zero, "materials.soft.young_modulus=" + std::to_string(modulus),
                                     "time.output=[1, 2]"}));
  };
  EXPECT_TRUE(of(1 / 0.049).empty());
  const auto found = of(1 / 0.25);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(says(found[0], {"strain", "25 %", "body 'lower'", "t = 1."}));
}

/// The load has gone at the output times.
TEST(SmallStrain, BetweenOutputs) {
  const Case blocks;
  const auto found = texts_of(
      blocks, {"loads=[{ on = 'top', pressure = { t = [0, 0.4, 0.5, 0.6, 4], values = [0, 0, 10, 0, 0] } }]", free_top,
               zero, "materials.soft.creep.0.A=1e-12", "materials.hard.creep.0.A=1e-12", "time.output=[2]"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(says(found[0], {"strain", "10 %", "body 'lower'", "t = 0.5."}));
}

TEST(SmallStrain, CreepStrainUpToItsEnd) {
  const Case blocks;
  const auto found = texts_of(blocks, {pressed, free_top, zero, "materials.soft.creep.0.A=0.1", "time.output=[1, 2]",
                                       "materials.soft.young_modulus=1e4"});
  ASSERT_EQ(found.size(), 1U);
  // The rate is A t^4 up to t = 1 and then A: A (1/5 + 3).
  EXPECT_TRUE(says(found[0], {"strain", "32 %", "body 'lower'", "t = 4."}));
}

TEST(SmallStrain, RotationsAboveTenDegrees) {
  const Case blocks;
  // Both bodies turn about z by 0.2 t rad as one piece.
  const std::string turned = R"(
[[rigid]]
on = "bottom"
origin = [0, 0, 0]
displacement = { x = 0, y = 0, z = 0 }
rotation = { x = 0, y = 0, z = "0.2*t" }
[[rigid]]
on = "top"
origin = [0, 0, 0]
displacement = { x = 0, y = 0, z = 0 }
rotation = { x = 0, y = 0, z = "0.2*t" }
)";
  const auto run_to = [&](double end) {
    std::string text = case_text.substr(0, case_text.find("[[supports]]")) + turned + R"(
[[contacts]]
between = ["lower_top", "upper_bottom"]
type = "tied"
[time]
end = )" + std::to_string(end) +
                       "\n";
    const Summary result = run(blocks.parse(text), {.output = (blocks / "out").string()});
    EXPECT_EQ(result.exit_status, 0) << result.message;
    std::vector<std::string> found;
    for (const std::string& warning : SummaryFile(blocks / "out/summary.json").texts("warnings"))
      if (contains(warning, "not small")) found.push_back(warning);
    return found;
  };
  EXPECT_TRUE(run_to(0.8).empty());  // 9.17 degrees
  const auto found = run_to(5);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(says(found[0], {"rotation", "57.3 degrees", "body '", "t = 5."}));
}

TEST(SmallStrain, ACheckOfTheStartSaysItToo) {
  const Case blocks;
  std::ostringstream report;
  check(blocks.config("", {"supports.3.displacement.z=-1"}), report, {.start = true});
  EXPECT_TRUE(says(report.str(), {"warning: ", "strain", "not small", "%", "body '"}));
}

TEST(SmallStrain, RemarksOfTheConfigurationAreRepeated) {
  const Case blocks;
  const config::Config config = blocks.config("", {"remarks=['NLGEOM is left out']", "time.end=1"});
  std::ostringstream report;
  check(config, report, {});
  EXPECT_TRUE(contains(report.str(), "warning: NLGEOM is left out\n")) << report.str();
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  const std::vector<std::string> warnings = SummaryFile(blocks / "out/summary.json").texts("warnings");
  EXPECT_NE(std::ranges::find(warnings, "NLGEOM is left out"), warnings.end());
}

}  // namespace
}  // namespace small_strain_tests
}  // namespace creepcontact::run::test
