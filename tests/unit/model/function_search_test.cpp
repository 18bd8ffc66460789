/// Every function of a configuration is searched: where it acts, and at the temperatures, stresses and strains it
/// meets.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

bool has(const std::vector<double>& times, double t, double error = 1e-9) {
  return std::ranges::any_of(times, [&](double found) { return std::abs(found - t) <= error * t; });
}

std::vector<double> breakpoints(const Case& blocks, const std::string& more,
                                const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all{"time.end=1000"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return build_model(blocks.config(more, all)).breakpoints;
}

/// A window of time in every key that takes a function of it, each at its own time.
TEST(FunctionSearch, EveryKey) {
  const Case blocks;
  std::vector<double> times;
  const auto window = [&] {
    times.push_back(100.3 + 50 * static_cast<double>(times.size()));
    return fmt::format("(t > {} && t < {} ? 0.2 : 0.1)", times.back(), times.back() + 1.7);
  };
  const std::string side = "[[loads]]\non = 'side_x'\n", body = "[[loads]]\nbody = 'upper'\n";
  std::string tables = side + "pressure = '" + window() + "'\n";
  tables += side + "traction = [0, 0, '" + window() + "']\n";
  tables += "[[loads]]\nat = [2, 1, 1]\nforce = [0, '" + window() + "', 0]\n";
  tables += body + "body_force = [0, 0, '" + window() + "']\n";
  tables += body + "rotation = { angular_velocity = '" + window() + "', density = 1 }\n";
  tables += body + "rotation = { angular_velocity = 1, density = '" + window() + "' }\n";
  tables += "[[supports]]\non = 'side_x'\ndisplacement = { normal = '1e-3*" + window() + "' }\n";
  tables += "[temperature]\nvalue = '100*" + window() + "'\n";
  std::vector<std::string> keys;
  for (const char* key : {"contacts.0.gap", "contacts.0.friction", "supports.3.displacement.z"})
    keys.push_back(fmt::format("{}='0.01*{}'", key, window()));
  keys.push_back("materials.hard.creep.0={ law = 'expression', rate = '1e-7*q*" + window() + "' }");
  const std::vector<double> found = breakpoints(blocks, tables, keys);
  for (const double t : times) EXPECT_TRUE(has(found, t, 1e-14) && has(found, t + 1.7, 1e-14)) << t;
  EXPECT_EQ(found.size(), 2 * times.size());
}

TEST(FunctionSearch, RatesOfStressStrainAndTime) {
  const Case blocks;
  const auto of = [&](const std::string& rate, const std::string& more = "") {
    return breakpoints(blocks, more, {"materials.soft.creep.0={ law = 'expression', rate = '" + rate + "' }"});
  };
  std::vector<double> found = of("t > 400 && t < 401 ? 1e-7*q : 0");
  EXPECT_TRUE(has(found, 400) && has(found, 401)) << testing::PrintToString(found);
  found = of("q > 1e-2 && t > 400 && t < 401 ? 1e-7*q : 1e-9");
  EXPECT_TRUE(has(found, 400) && has(found, 401)) << testing::PrintToString(found);
  found = of("1e-7*q/(1e-3 + eps) + (eps < 1e-4 && t > 33 ? 1e-3 : 0)");
  EXPECT_TRUE(has(found, 33)) << testing::PrintToString(found);
  found = of("1e-7*q*exp(-((t - 700)/3)^2)");
  EXPECT_TRUE(has(found, 700, 1e-4)) << testing::PrintToString(found);
  found = of("T > 150 && t > 500 ? 1e-7*q : 0", "[temperature]\nvalue = '100*(z + 2)'\n");
  EXPECT_TRUE(has(found, 500)) << testing::PrintToString(found);
}

/// What acts at some places only, among them small ones, moving ones, and ones where others have no value.
TEST(FunctionSearch, Places) {
  const Case blocks;
  std::vector<double> found = breakpoints(
      blocks, "[[loads]]\non = 'side_x'\npressure = '(z > 0.6 && y < 0.4 && t > 401.7 && t < 402.1) ? 0.3 : 0.1'\n");
  EXPECT_TRUE(has(found, 401.7) && has(found, 402.1)) << testing::PrintToString(found);
  found = breakpoints(blocks,
                      "[temperature]\nvalue = '(x > 1.52 && x < 1.9 && z > 0.8 && t > 77.7 && t < 81) ? 30 : 20'\n");
  EXPECT_TRUE(has(found, 77.7) && has(found, 81)) << testing::PrintToString(found);
  found = breakpoints(blocks,
                      "[[loads]]\non = 'side_x'\ntraction = ['0.1*sqrt(max(z, 0)) + 0*sqrt(z + 2)', 0, "
                      "'(z > 0.4 ? sqrt(z - 0.4) : 0)*(t > 250 && t < 251 ? 1 : 0.1)']\n");
  EXPECT_TRUE(has(found, 250) && has(found, 251)) << testing::PrintToString(found);
  // A front that moves: some of the places it passes.
  found = breakpoints(blocks, "[temperature]\nvalue = 'z > 1 - t/500 ? 100 : 20'\n");
  EXPECT_GT(found.size(), 5U);
  EXPECT_LT(found.size(), 60U);
  for (const double t : found) EXPECT_LT(t, 1000);
}

/// E of a table in T, under a temperature that goes up and down.
TEST(FunctionSearch, TemperaturesPassPointsOfTables) {
  const Case blocks;
  const std::vector<std::string> table{
      "materials.soft.young_modulus={ T = [0, 150, 200.5, 300], values = [100, 95, 80, 50] }"};
  std::vector<double> found = breakpoints(blocks, "[temperature]\nvalue = '100 + 0.2*t'\n", table);
  EXPECT_EQ(found.size(), 2U) << testing::PrintToString(found);
  EXPECT_TRUE(has(found, 250, 1e-12) && has(found, 502.5, 1e-12)) << testing::PrintToString(found);
  found = breakpoints(blocks, "[temperature]\nvalue = '100 + 110*(1 - abs(t - 500)/500)'\n", table);
  EXPECT_TRUE(has(found, 500, 1e-12));
  for (const double rise : {50.0, 100.5})
    for (const double side : {-1.0, 1.0})
      EXPECT_TRUE(has(found, 500 + side * 500 * (1 - rise / 110), 1e-11)) << testing::PrintToString(found);
  // A jump over a point is no passage of its own.
  found = breakpoints(blocks, "[temperature]\nvalue = 't < 300 ? 100 : 180'\n", table);
  EXPECT_EQ(found, std::vector<double>{300});
  // In a gradient: from the first to the last place.
  found = breakpoints(blocks, "[temperature]\nvalue = '100 + 0.2*t + 5*z'\n",
                      {"materials.soft.young_modulus={ T = [0, 150, 400], values = [100, 95, 40] }"});
  EXPECT_TRUE(has(found, 250, 1e-11) && has(found, 300, 1e-11)) << testing::PrintToString(found);
  EXPECT_GE(found.size(), 3U);
  EXPECT_LE(found.size(), 5U);
}

TEST(FunctionSearch, TemperaturesFromAFilePassPointsOfTables) {
  const Case blocks;
  io::test::write_text(blocks / "T.csv", "x,y,z,t,T\n0,0,-2,0,100\n2,1,1,0,100\n0,0,-2,1000,300\n2,1,1,1000,300\n");
  const std::vector<double> found =
      breakpoints(blocks, "[temperature]\nfile = 'T.csv'\n",
                  {"materials.soft.young_modulus={ T = [0, 150, 200.5, 400], values = [100, 95, 80, 50] }"});
  EXPECT_EQ(found.size(), 2U) << testing::PrintToString(found);
  EXPECT_TRUE(has(found, 250, 1e-10) && has(found, 502.5, 1e-10)) << testing::PrintToString(found);
}

/// Pulses at random places and times, in half of the elements or a few of them.
TEST(FunctionSearch, RandomPulses) {
  const Case blocks;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 6; ++run) {
    const double begin = 20 + 900 * uniform(random), end = begin + 0.5 + 20 * uniform(random);
    const double z = -2 + 2.5 * uniform(random), x = uniform(random);
    const std::string pulse =
        fmt::format("(t > {} && t < {} && z > {} && z < {} && x > {}) ? 50 : 20", begin, end, z, z + 0.5, x);
    const std::vector<double> found = breakpoints(blocks, "[temperature]\nvalue = '" + pulse + "'\n");
    EXPECT_TRUE(has(found, begin) && has(found, end)) << pulse << testing::PrintToString(found);
  }
}

TEST(FunctionSearch, VibrationsBoundSteps) {
  const Case blocks;
  testing::internal::CaptureStderr();
  const Model model = build_model(
      blocks.config("[[loads]]\non = 'side_x'\npressure = '0.1 + 0.05*sin(2*pi*t*7)'\n", {"time.end=1000"}));
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_EQ(model.breakpoints.size(), 2U);  // its highest and lowest value
  const double step = model.step_limits.latest_end(333.3) - 333.3;
  EXPECT_GT(step, 1 / 7.0 / 20);
  EXPECT_LT(step, 1 / 7.0 / 10);
  testing::internal::CaptureStderr();
  const Model too_fast = build_model(
      blocks.config("[[loads]]\non = 'side_x'\npressure = '0.1 + 0.05*sin(2*pi*t*1e5)'\n", {"time.end=1000"}));
  EXPECT_TRUE(
      contains(testing::internal::GetCapturedStderr(), "'loads[0].pressure' (0.1 + 0.05*sin(2*pi*t*1e5)) turns"));
  EXPECT_TRUE(too_fast.step_limits.empty());
}

}  // namespace
}  // namespace creepcontact::run::test
