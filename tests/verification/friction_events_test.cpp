/// Friction in steps that reach from breakpoint to breakpoint: what happens within them, against very many steps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_events {
namespace {

/// A block pressed on a softer foot and moved to and fro, while the pressure changes: nodes open, close, stick and
/// slip.
struct Pair {
  bool is_solid = true;
  double A = 0;  ///< creep constant, n = 3

  std::string toml(const std::string& time) const {
    const std::string normal = is_solid ? "z" : "y", top = "block_" + normal + "1", foot = "foot_" + normal + "0";
    std::string text = is_solid ? "[mesh]\nfile = \"case.geo\"\norder = 1\nallow_locking = true\n"
                                : test::section_of("plane_strain", 1);
    text += test::body("foot", 2e5, 0, A, 3) + test::body("block", 4e4, 0.45, A, 3);
    for (const char* component : {"x", "y", "z"})
      if (is_solid || *component != 'z') text += test::support(foot, component);
    text += test::support(top, "x", "{ t = [0, 500, 1000], values = [0, -0.05, 0.04] }");
    if (is_solid) text += test::support(top, "y", "{ t = [0, 500, 1000], values = [0, 0.02, 0.01] }");
    return text + "[[loads]]\non = \"" + top + "\"\npressure = { t = [0, 500, 1000], values = [23, 40, 12] }\n" +
           "[[contacts]]\nname = \"c\"\nbetween = [\"foot_" + normal + "1\", \"block_" + normal +
           "0\"]\nfriction = 0.6\n[time]\nend = 1000\ntolerance = 1e-4\noutput = { count = 12, spacing = \"linear\" "
           "}\n" +
           time + test::probe("x", "contact_force_x", "on = \"foot_" + normal + "1\"") +
           test::probe("normal", "contact_force_" + normal, "on = \"foot_" + normal + "1\"") +
           test::probe("largest", "slip", "on = \"foot_" + normal + "1\"\nreduce = \"max\"") +
           test::probe("mean", "slip", "on = \"foot_" + normal + "1\"");
  }
  std::string geo() const {
    if (is_solid)
      return test::boxes_geo(
          {{"foot", {0, 0, 0}, {16, 9, 5}, {4, 3, 2}}, {"block", {2, 1, 5}, {12, 7, 12}, {3, 2, 4}}});
    return test::regions_geo({{"foot", {0, 16, 10}, {0, 5, 3}}, {"block", {2, 14, 7}, {5, 17, 6}}});
  }
  test::Outcome run(const std::string& time = "", const std::vector<std::string>& overrides = {}) const {
    return test::run_case(toml(time), geo(), overrides);
  }
  /// With breakpoints so close that each step is accurate by itself.
  test::Outcome run_finely(const std::vector<std::string>& overrides = {}) const {
    constexpr int many = 200;
    std::string times;
    for (int k = 1; k < many; ++k) times += fmt::format("{}{:.17g}", k > 1 ? ", " : "", 1000.0 * k / many);
    return run("breakpoints = [" + times + "]\n", overrides);
  }
};

double largest_of(const test::Table& history, const std::string& name) {
  double largest = 0;
  for (const double value : history.column(name)) largest = std::max(largest, std::abs(value));
  return largest;
}

void expect_same_path(const test::Outcome& found, const test::Outcome& exact, double forces, double slip) {
  for (const char* name : {"x", "normal", "largest", "mean"}) {
    const bool is_slip = std::string(name) == "largest" || std::string(name) == "mean";
    const double size = largest_of(exact.history, name);
    ASSERT_GT(size, 0);
    for (const double t : exact.history.times())
      EXPECT_NEAR(found.history.at(name, t) / size, exact.history.at(name, t) / size, is_slip ? slip : forces)
          << name << " at " << t;
  }
  for (const char* name : {"largest", "mean"}) {
    const std::vector<double>& values = found.history.column(name);
    EXPECT_TRUE(std::ranges::is_sorted(values)) << name << " falls";
  }
  const char* energy = "contacts/c/dissipated_energy";
  EXPECT_RELATIVE(found.summary.number(energy), exact.summary.number(energy), slip);
}

TEST(FrictionEvents, OfSolidsInLongSteps) {
  const Pair pair;
  const test::Outcome found = pair.run(), exact = pair.run_finely();
  EXPECT_LT(found.summary.number("elastic_solves"), 60) << "substeps cost no elastic solves";
  expect_same_path(found, exact, 2e-3, 1e-2);
}

TEST(FrictionEvents, OfSectionsInLongSteps) {
  const Pair pair{.is_solid = false};
  expect_same_path(pair.run(), pair.run_finely(), 2e-3, 1e-2);
}

TEST(FrictionEvents, WithALittleCreep) {
  for (const char* integrator : {"", "integrator = \"cvode_bdf\"\n", "integrator = \"arkode_erk\"\n"}) {
    const Pair pair{.A = 1e-14};
    const test::Outcome exact = pair.run_finely();
    expect_same_path(pair.run(integrator), exact, 1e-2, 3e-2);
  }
}

TEST(FrictionEvents, WithStiffnessThatChanges) {
  const Pair pair{.is_solid = false};
  const std::vector<std::string> overrides{"temperature.value='20+0.4*t'",
                                           "materials.block.young_modulus={T=[20,420],values=[4e4,3e4]}"};
  expect_same_path(pair.run("", overrides), pair.run_finely(overrides), 5e-3, 2e-2);
}

// There substeps are four times as long.
TEST(FrictionEvents, WithoutMatrices) {
  const Pair pair{.is_solid = false};
  const std::vector<std::string> overrides{"contact_solver.dense_limit_mb=0"};
  expect_same_path(pair.run("", overrides), pair.run_finely(), 3e-2, 0.1);
}

TEST(FrictionEvents, OutputsDoNotChangeARun) {
  const Pair pair{.is_solid = false, .A = 1e-14};
  const test::Outcome few = pair.run("integrator = \"cvode_bdf\"\n", {"time.output=[1000]"}),
                      many = pair.run("integrator = \"cvode_bdf\"\n");
  for (const char* name : {"x", "normal"}) EXPECT_EQ(few.history.at(name, 1000), many.history.at(name, 1000)) << name;
  EXPECT_EQ(few.summary.number("steps"), many.summary.number("steps"));
  // Results do not fall below those of an output before, which lie on the path to within the tolerance.
  for (const char* name : {"largest", "mean"})
    EXPECT_NEAR(few.history.at(name, 1000) / many.history.at(name, 1000), 1, 1e-4) << name;
}

/// Two blocks pressed on each other and sheared, whose friction depends on time.
test::Outcome run_with_friction(const std::string& mu, const std::string& breakpoints) {
  std::string toml =
      test::section_of("plane_strain", 1) + test::body("low", 2.1e5, 0.3) + test::body("high", 2.1e5, 0.3);
  toml += test::support("low_y0", "x") + test::support("low_y0", "y") + test::support("high_y1", "y", "-0.01") +
          test::support("high_y1", "x", "\"1e-3*min(t, 10)/10\"") +
          "[[contacts]]\nname = \"c\"\nbetween = [\"low_y1\", \"high_y0\"]\nfriction = \"" + mu + "\"\n" +
          "[time]\nend = 100\noutput = [10, 49, 51, 100]\nbreakpoints = [" + breakpoints + "]\n" +
          test::probe("x", "contact_force_x", "on = \"high_y0\"") +
          test::probe("y", "contact_force_y", "on = \"high_y0\"");
  return test::run_case(toml, test::regions_geo({{"low", {0, 2, 4}, {0, 1, 2}}, {"high", {0, 2, 4}, {1, 2, 2}}}));
}

// Friction falls to almost nothing for a while; what has slipped then does not come back.
TEST(FrictionEvents, CoefficientThatFallsForAWhile) {
  const test::Outcome outcome = run_with_friction("t > 40 && t < 45 ? 0.001 : 0.5", "10, 40, 45");
  EXPECT_GT(std::abs(outcome.history.at("x", 10)), 10 * std::abs(outcome.history.at("x", 49)));
  for (const double t : {49.0, 51.0, 100.0})
    EXPECT_RELATIVE(outcome.history.at("x", t), -0.001 * outcome.history.at("y", t), 1e-6);
}

// Slip within a thousandth of the step, against substeps that are told where.
TEST(FrictionEvents, EnergyOfACoefficientThatDipsShortly) {
  const std::string mu = "0.5 - 0.499*exp(-((t - 50)/0.05)^2)", key = "contacts/c/dissipated_energy";
  std::string times = "10";
  for (int k = -40; k <= 40; ++k) times += fmt::format(", {:.6g}", 50 + 0.005 * k);
  const double exact = run_with_friction(mu, times).summary.number(key);
  EXPECT_RELATIVE(run_with_friction(mu, "10").summary.number(key), exact, 4e-3);
}

// Loads that are not linear in time, and turn back where no breakpoint is.
TEST(FrictionEvents, LoadsThatTurnBackUnannounced) {
  const Pair pair{.is_solid = false};
  const std::vector<std::string> waves{"supports.2.displacement.x='-0.05*sin(t/160) - 0.02*sin(t/70)'"};
  expect_same_path(pair.run("", waves), pair.run_finely(waves), 5e-3, 2e-2);
}

}  // namespace
}  // namespace friction_events
}  // namespace creepcontact
