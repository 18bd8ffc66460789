/// Two parallel bars under a force, one of them heated and cooled in cycles: P the mean stress relative to the yield
/// stress, St = E alpha dT/2 likewise, the elastic thermal stress of each bar. They shake down while P + St/2 <= 1 and
/// ratchet by E d eps = 2 (2 P + St - 2) per cycle beyond (J. Bree, J. Strain Anal. 2 (1967) 226, for two bars).

#include <fmt/format.h>

#include <vector>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_ratchet_tests {
namespace {

using namespace test;

struct Bars {
  std::vector<double> strain;  ///< E times the strain, cold, after each cycle
  std::vector<double> flow;    ///< E times the accumulated plastic strain of the cold bar
};

Bars run_bars(double P, double St, int n_cycles, const std::string& hardening = "") {
  std::string times = "0", values = "0", outputs = "1";
  for (int i = 0; i < n_cycles; ++i) {
    times += fmt::format(", {}, {}", i + 0.5, i + 1);
    values += ", 1, 0";
    if (i > 0) outputs += fmt::format(", {}", i + 1);
  }
  const std::string toml =
      fmt::format(R"toml({}
        [bodies.cold]
        region = "cold"
        material = "alloy"
        [bodies.hot]
        region = "hot"
        material = "heated"
        [generalized_plane_strain]
        force = {}
        [temperature]
        value = {{ t = [{}], values = [{}] }}
        [time]
        end = {}
        output = [{}]
        tolerance = 1e-6
      )toml",
                  section_of("generalized_plane_strain", 1), 2 * P, times, values, n_cycles, outputs) +
      fmt::format(R"toml(
        [materials.alloy]
        young_modulus = 1000
        poisson_ratio = 0.3
        plasticity = {{ yield_stress = 1{0} }}
        [materials.heated]
        young_modulus = 1000
        poisson_ratio = 0.3
        reference_temperature = 0
        thermal_expansion = {1}
        plasticity = {{ yield_stress = 1{0} }}
      )toml",
                  hardening, 2 * St / 1000) +
      support("cold_x0", "x") + support("cold_y0", "y") + support("hot_x0", "x") + support("hot_y0", "y") +
      probe("strain", "axial_strain", "body = \"cold\"") +
      probe("flow", "plastic_strain_equivalent", "body = \"cold\"\nreduce = \"mean\"");
  const Table history =
      run_case(toml, regions_geo({{"cold", {0, 1, 1}, {0, 1, 1}}, {"hot", {2, 3, 1}, {0, 1, 1}}})).history;
  Bars result;
  for (int i = 1; i <= n_cycles; ++i) {
    result.strain.push_back(1000 * history.at("strain", i));
    result.flow.push_back(1000 * history.at("flow", i));
  }
  return result;
}

TEST(PlasticTwoBars, RatchetByTheClosedForm) {
  for (const auto& [P, St] : {std::pair{0.6, 1.5}, {0.8, 0.7}, {0.4, 1.3}, {0.9, 1.9}}) {
    const Bars bars = run_bars(P, St, 5);
    for (int i = 1; i < 5; ++i)
      EXPECT_NEAR(bars.strain[i] - bars.strain[i - 1], 2 * (2 * P + St - 2), 1e-5) << P << ' ' << St << ' ' << i;
  }
}

TEST(PlasticTwoBars, ShakeDownBelowTheLimit) {
  for (const auto& [P, St] : {std::pair{0.6, 0.79}, {0.2, 1.55}, {0.9, 0.19}}) {
    const Bars bars = run_bars(P, St, 4);
    EXPECT_NEAR(bars.strain[3], bars.strain[1], 1e-9) << P << ' ' << St;
    EXPECT_NEAR(bars.flow[3], bars.flow[1], 1e-9) << P << ' ' << St;
  }
  const Bars elastic = run_bars(0.3, 0.69, 2);
  EXPECT_EQ(elastic.flow[1], 0);
  EXPECT_GT(run_bars(0.3, 0.71, 2).flow[1], 0) << "the cold bar has 1.01 when the other is hot";
}

/// Linear kinematic hardening ends the ratchet: what a cycle adds falls in a constant proportion.
TEST(PlasticTwoBars, ShakeDownWhereTheyHarden) {
  const Bars bars = run_bars(0.6, 1.5, 8, ", kinematic = [{ C = 200, gamma = 0 }]");
  std::vector<double> added;
  for (int i = 1; i < 8; ++i) added.push_back(bars.strain[i] - bars.strain[i - 1]);
  for (int i = 2; i < 7; ++i) EXPECT_NEAR(added[i] / added[i - 1], added[1] / added[0], 1e-4) << i;
  EXPECT_LT(added[1], 0.9 * added[0]);
}

}  // namespace
}  // namespace plastic_ratchet_tests
}  // namespace creepcontact
