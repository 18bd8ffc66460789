/// Criteria: the extremes over all steps, against closed forms.

#include "creepcontact/results/criteria.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "verification/cube.hpp"
#include "verification/interrupted.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace criteria_tests {
namespace {

using namespace test;
using Criterion = io::Summary::Criterion;

std::string criterion(const std::string& name, const std::string& keys) {
  return fmt::format("\n[[criteria]]\nname = \"{}\"\n{}\n", name, keys);
}

TEST(Utilisation, OfBothKindsAndAllSigns) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const auto& [found, allowed, of_maximum, of_minimum] :
       std::vector<std::array<double, 4>>{{50, 100, 0.5, 2},
                                          {200, 100, 2, 0.5},
                                          {-5, 100, 0, infinite},
                                          {-50, -100, infinite, 0.5},
                                          {0, 0, 0, 0},
                                          {1, 0, infinite, 0},
                                          {-1, 0, 0, infinite},
                                          {0, 100, 0, infinite}}) {
    if (found != -50) {
      EXPECT_EQ(results::utilisation(found, allowed, false), of_maximum) << found << ", " << allowed;
    }
    EXPECT_EQ(results::utilisation(found, allowed, true), of_minimum) << found << ", " << allowed;
  }
  EXPECT_EQ(results::utilisation(-50, -100, false), 2);  // above a negative maximum
}

/// A vibrating stress of which no output time sees the largest value.
TEST(Criteria, SeeWhatOutputsDoNot) {
  const std::string load = pulled("\"100 + 50*sin(2*pi*t)\"");
  const std::string common = "end = 3\noutput = [1, 2]\n";
  const Outcome outcome = run_cube("",
                                   load + criterion("peak", "probe = \"sxx\"\nmax = 120") +
                                       criterion("low", "expression = \"sxx/2\"\nmin = 20") +
                                       criterion("late", "probe = \"sxx\"\nmax = 200\nfrom = 2.6\nuntil = 2.8"),
                                   common);
  const auto& all = outcome.summary;
  EXPECT_EQ(all.truth("criteria/peak/met"), false);
  EXPECT_NEAR(all.number("criteria/peak/found"), 150, 0.01);
  EXPECT_NEAR(all.number("criteria/peak/utilisation"), 1.25, 1e-4);
  EXPECT_EQ(all.truth("criteria/low/met"), true);
  EXPECT_NEAR(all.number("criteria/low/found"), 25, 0.01);
  EXPECT_NEAR(all.number("criteria/low/utilisation"), 0.8, 1e-3);
  // Between sin(2 pi 2.6) and sin(2 pi 2.8) it is lowest in between and largest at the ends.
  EXPECT_NEAR(all.number("criteria/late/found"), 100 + 50 * std::sin(2 * std::acos(-1.0) * 2.6), 1e-3);
}

/// The time itself counts, though no step ends there.
TEST(Criteria, AtOneTime) {
  const Outcome outcome = run_cube(
      "", pulled("\"10*t\"") + criterion("then", "probe = \"sxx\"\nmax = { t = [0, 10], values = [0, 20] }\nat = 3.7"),
      "end = 10\n");
  EXPECT_NEAR(outcome.summary.number("criteria/then/time"), 3.7, 1e-9);
  EXPECT_NEAR(outcome.summary.number("criteria/then/found"), 37, 1e-6);
  EXPECT_NEAR(outcome.summary.number("criteria/then/allowed"), 7.4, 1e-8);
  EXPECT_EQ(outcome.summary.truth("criteria/then/met"), false);
}

/// A limit that falls for a while between two steps.
TEST(Criteria, LimitsThatJumpAreSeen) {
  const std::string limit = "{ t = [0, 4.1, 4.1, 4.2, 4.2, 10], values = [50, 50, 5, 5, 50, 50] }";
  const Outcome outcome =
      run_cube("", pulled("10") + criterion("dip", "probe = \"sxx\"\nmax = " + limit), "end = 10\n");
  EXPECT_EQ(outcome.summary.truth("criteria/dip/met"), false);
  EXPECT_NEAR(outcome.summary.number("criteria/dip/utilisation"), 2, 1e-9);
}

/// von Mises stress over a yield strength that falls with the temperature.
TEST(Criteria, YieldWithSafetyOverTheTemperature) {
  const Outcome outcome = run_cube("reference_temperature = 20\nyield_strength = \"300 - 0.2*(T - 20)\"",
                                   pulled("150") + "\n[temperature]\nvalue = \"20 + 50*t\"\n" +
                                       criterion("yield", "kind = \"yield\"\nsafety = 1.5") +
                                       criterion("field", "quantity = \"stress_xx\"\nbody = \"cube\"\nmax = \"2*T\""),
                                   "end = 10\n");
  EXPECT_NEAR(outcome.summary.number("criteria/yield/allowed"), 200 / 1.5, 1e-9);
  EXPECT_NEAR(outcome.summary.number("criteria/yield/utilisation"), 150 * 1.5 / 200, 1e-9);
  EXPECT_EQ(outcome.summary.text("criteria/yield/body"), "cube");
  EXPECT_NEAR(outcome.summary.number("criteria/field/utilisation"), 150 / 40.0, 1e-9);  // at the start
  EXPECT_EQ(outcome.summary.number("criteria/field/time"), 0);
}

/// The stress that ruptures after a given time, from the time that a stress needs.
TEST(Criteria, RuptureStrengthInvertsTheData) {
  const Outcome outcome =
      run_cube("rupture = { rupture_time = \"1e10*q^-4\" }",
               pulled("50") + criterion("rupture", "quantity = \"von_mises\"\nmax = \"rupture_strength\"\nlife = 1e2") +
                   criterion("life", "kind = \"creep_life\""),
               "end = 10\n");
  const double strength = std::pow(1e10 / 1e2, 0.25);
  EXPECT_NEAR(outcome.summary.number("criteria/rupture/allowed"), strength, 1e-6 * strength);
  EXPECT_NEAR(outcome.summary.number("criteria/life/found"), 10 / (1e10 * std::pow(50, -4)), 1e-6);
  EXPECT_EQ(outcome.summary.number("criteria/life/allowed"), 1);
}

/// Points near a corner do not count.
TEST(Criteria, AwayFromPoints) {
  const Region region{"strip", {0, 10, 10}, {0, 1, 2}};
  const std::string toml =
      section_of("plane_stress") + body("strip", 1000, 0) + support("strip_x0", "x") + support("strip_y0", "y") +
      "[[loads]]\nbody = \"strip\"\nbody_force = [1, 0, 0]\n[time]\nend = 1\n" +
      criterion("all", "quantity = \"stress_xx\"\nbody = \"strip\"\nmax = 20") +
      criterion("away", "quantity = \"stress_xx\"\nbody = \"strip\"\nmax = 20\naway_from = [[0, 0, 0]]\ndistance = 5");
  const Outcome outcome = run_case(toml, regions_geo({region}));
  EXPECT_GT(outcome.summary.number("criteria/all/found"), 9.5);  // 10 - x
  EXPECT_LT(outcome.summary.number("criteria/away/found"), 5.1);
  EXPECT_GT(outcome.summary.number("criteria/away/found"), 4.5);
}

/// A bent and stretched strip that creeps by a law linear in the stress: the strain is linear through it.
TEST(Criteria, StrainThroughAWallIsLinearised) {
  const double A = 1e-5, end = 10, mean = 20, slope = 4;  // stress mean + slope (y - 5)
  const Region region{"strip", {0, 40, 8}, {0, 10, 4}};
  const std::string toml = section_of("plane_stress") + body("strip", 1e5, 0.3, A, 1) + support("strip_x0", "x") +
                           support("corner", "y") + "[time]\nend = 10\n" +
                           criterion("wall",
                                     "kind = \"creep_strain\"\nbody = \"strip\"\n"
                                     "path = [[20, 0, 0], [20, 10, 0]]\nstrains = [1e-3, 1e-2, 1e-2]");
  std::string geo = regions_geo({region});
  geo += "Physical Point(\"corner\") = {1};\n";
  std::string loaded =
      toml + fmt::format("[[loads]]\non = \"strip_x1\"\ntraction = [\"{} + {}*(y - 5)\", 0, 0]\n", mean, slope);
  const Outcome outcome = run_case(loaded, geo);
  EXPECT_NEAR(outcome.summary.number("criteria/wall/found"), A * mean * end, 1e-3 * A * mean * end);
  EXPECT_NEAR(outcome.summary.number("criteria/wall/utilisation"), A * mean * end / 1e-3, 1e-2);
  loaded.replace(loaded.find("strains = [1e-3"), 15, "strains = [1e+3");
  loaded.replace(loaded.find("1e-2, 1e-2]"), 11, "1e-3, 1e+2]");
  const Outcome bent = run_case(loaded, geo);
  EXPECT_NEAR(bent.summary.number("criteria/wall/found"), A * (mean + 5 * slope) * end, 1e-3 * A * 40 * end);
}

/// An interrupted run judges what the whole one does.
TEST(Criteria, GoOnWithTheRun) {
  const CaseDirectory directory(cube_geo);
  const config::Config config = directory.config(
      cube_toml(creep_law_table("norton", "A = 1e-9\nn = 2"),
                pulled("\"100 + 50*sin(t)\"") + criterion("peak", "probe = \"sxx\"\nmax = 120\nuntil = 4") +
                    criterion("then", "probe = \"cxx\"\nmax = 1\nat = 2.5"),
                "end = 10\n"),
      {});
  expect_same_when_resumed(config, directory.path(), {2, 6});
  const SummaryFile whole(directory.path() / "whole/summary.json"), parts(directory.path() / "parts/summary.json");
  for (const char* key : {"criteria/peak/found", "criteria/peak/time", "criteria/then/found", "criteria/then/time"})
    EXPECT_EQ(whole.number(key), parts.number(key)) << key;
}

/// The same strip without creep: 20 on average, 40 at its edge.
TEST(Criteria, StressThroughAWallIsLinearised) {
  const Region region{"strip", {0, 40, 8}, {0, 10, 4}};
  const std::string path = "quantity = \"von_mises\"\nbody = \"strip\"\nmax = 30\npath = [[20, 0, 0], [20, 10, 0]]\n";
  const std::string toml = section_of("plane_stress") + body("strip", 1e5, 0.3) + support("strip_x0", "x") +
                           support("corner", "y") + "[time]\nend = 1\n" +
                           "[[loads]]\non = \"strip_x1\"\ntraction = [\"20 + 4*(y - 5)\", 0, 0]\n" +
                           criterion("membrane", path + "part = \"membrane\"") + criterion("edge", path);
  const Outcome outcome = run_case(toml, regions_geo({region}) + "Physical Point(\"corner\") = {1};\n");
  EXPECT_NEAR(outcome.summary.number("criteria/membrane/found"), 20, 1e-6);
  EXPECT_NEAR(outcome.summary.number("criteria/edge/found"), 40, 1e-6);
  EXPECT_TRUE(outcome.summary.truth("criteria/membrane/met"));
  EXPECT_FALSE(outcome.summary.truth("criteria/edge/met"));
}

TEST(Criteria, MistakesAreNamed) {
  const auto message = [](const std::string& keys) -> std::string {
    try {
      const CaseDirectory directory(cube_geo);
      directory.config(cube_toml("", pulled("10") + criterion("x", keys), "end = 10\n"), {});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::vector<std::pair<std::string, std::vector<std::string_view>>> mistakes{
      {"probe = \"sx\"\nmax = 1", {"criteria[0].probe", "'sx'", "sxx"}},
      {"expression = \"2*sx\"\nmax = 1", {"criteria[0].expression", "'sx'", "sxx"}},
      {"probe = \"sxx\"", {"criteria[0]", "no limit", "min"}},
      {"max = 1", {"criteria[0]", "nothing that it is about"}},
      {"probe = \"sxx\"\nkind = \"yield\"", {"'probe' and 'kind'"}},
      {"probe = \"sxx\"\nmax = \"yield_strength\"", {"criteria[0].max", "place"}},
      {"kind = \"yield\"", {"criteria[0]", "yield_strength"}},
      {"kind = \"leak\"\nmin = 1", {"no contact"}},
      {"kind = \"creep_strain\"\nbody = \"cube\"", {"no path"}},
      {"probe = \"sxx\"\nmax = 1\nat = 20", {"criteria[0].at", "time.end"}},
      {"probe = \"sxx\"\nmax = 1\nat = 2\nfrom = 1", {"criteria[0].from", "'at'"}},
      {"quantity = \"contact_pressure\"\nmax = 1", {"criteria[0].quantity", "'contact_pressure'"}}};
  for (const auto& [keys, facts] : mistakes) EXPECT_TRUE(says(message(keys), facts)) << keys << "\n" << message(keys);
}

}  // namespace
}  // namespace criteria_tests
}  // namespace creepcontact
