/// The creep life that cycles of the loads use up: the stress of the lower block follows the displacement, up to 1 and
/// back to 0 in each cycle of 2, and a life of `life` at the stress 1 that goes with its 12th power leaves
/// 2/(13 life) to each.

#include <fmt/format.h>

#include <utility>

#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

constexpr double used_per_cycle = 2.0 / 13;  // of a life of 1

config::Config triangles(const Case& blocks, double life, int n_cycles, std::vector<std::string> more) {
  for (const char* material : {"soft", "hard"}) more.push_back(fmt::format("materials.{}.creep.0.A=1e-13", material));
  more.insert(more.end(), {"supports.3.displacement.z={ t=[0, 1, 2], values=[0, -0.025, 0], period=2 }",
                           fmt::format("materials.soft.rupture={{ rupture_time='{}*q^-12' }}", life), "time.cycle=2",
                           fmt::format("time.end={}", 2 * n_cycles), "output.fields=false"});
  return blocks.config("[[probes]]\nname = 'life'\nquantity = 'life_fraction'\nbody = 'lower'\n", more);
}

/// An error of each cycle in the same direction would add up.
TEST(CycleLives, AreRightAfterManyCycles) {
  constexpr double life = 100;
  constexpr int n_cycles = 100;
  for (const char* integrator : {"auto", "cvode_bdf"}) {
    const Case blocks;
    const config::Config config =
        triangles(blocks, life, n_cycles, {fmt::format("time.integrator={}", integrator), "time.tolerance=1e-4"});
    const Summary result = run(config, {.output = (blocks / "out").string()});
    ASSERT_EQ(result.exit_status, 0) << result.message;
    const double exact = n_cycles * used_per_cycle / life;
    EXPECT_NEAR(Table(blocks / "out" / "history.csv").column("life").back(), exact, 0.015 * exact) << integrator;
  }
}

TEST(CycleLives, ALimitThatIsPassedStays) {
  constexpr double life = 5, exact = life / used_per_cycle;  // 32.5 cycles
  const Case blocks;
  const config::Config first = triangles(blocks, life, 40, {}), more = triangles(blocks, life, 60, {});
  ASSERT_EQ(run(first, {.output = (blocks / "out").string()}).exit_status, 0);
  ASSERT_EQ(run(more, {.output = (blocks / "out").string(), .resume = true}).exit_status, 0);
  const std::vector<double> limits = Table(blocks / "out" / "cycles.csv").column("lower.cycles_to_limit");
  ASSERT_EQ(limits.size(), 60u);
  for (const double limit : limits) EXPECT_NEAR(limit, exact, 0.02 * exact);
  for (std::size_t i = 33; i < limits.size(); ++i) EXPECT_EQ(limits[i], limits[33]) << "cycle " << i;
}

TEST(CycleLives, CyclesThatRepeatBeforeOthersDoNotEndTheRun) {
  const Case blocks;
  const config::Config config = triangles(
      blocks, 100, 10, {"time.stop_when_steady=0.01", "supports.3.displacement.y='t < 14 ? 0 : -0.001*(t - 14)'"});
  ASSERT_EQ(run(config, {.output = (blocks / "out").string()}).exit_status, 0);
  EXPECT_EQ(Table(blocks / "out" / "history.csv").times().back(), 20);
}

}  // namespace
}  // namespace creepcontact::run::test
