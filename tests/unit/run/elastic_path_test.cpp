/// Loads without creep between two output times: what happens there is part of the results after it.

#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Pressures at output times; the displacement makes 0.3 per time.
std::vector<double> pressures(const std::string& output, const std::string& friction) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe, elastic({"supports.3.displacement.z='-0.0075*t'", "contacts.0.friction=" + friction,
                               "contacts.0.preload={ force = 0.5, at = 1 }", "time.output=" + output, "time.end=3"}));
  const Summary result = run(config, {.output = (blocks / "out").string()});
  EXPECT_EQ(result.exit_status, 0) << result.message;
  return Table(blocks / "out" / "history.csv").column("pressure");
}

TEST(ElasticPath, APreloadIsAppliedAtItsTimeWithTheLoadsThere) {
  for (const char* friction : {"0", "0.2"}) {
    const std::vector<double> with_output = pressures("[1, 3]", friction), without = pressures("[3]", friction);
    EXPECT_NEAR(with_output[1], 0.25, 1e-8) << friction;
    EXPECT_NEAR(without.back(), with_output.back(), 1e-8) << friction;
  }
  EXPECT_NEAR(pressures("[3]", "0").back(), 0.25 + 2 * 0.3, 1e-8);
}

}  // namespace
}  // namespace creepcontact::run::test
