/// Loads, supports, gaps and temperatures that jump: no step sees both sides of a jump.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxes.hpp"
#include "case.hpp"
#include "rings.hpp"

namespace creepcontact::test {
namespace jumps_tests {
namespace {

constexpr double E = 2e5, A = 1e-13, n = 4;  // [MPa], [1/h]

const std::vector<std::string> integrators{"cvode_bdf",   "cvode_adams",    "log_adams", "arkode_erk",
                                           "arkode_dirk", "explicit_euler", "beta_euler"};

/// A bar of 2 along z, free at its sides.
std::string bar_geo() {
  return boxes_geo({{"bar", {0, 0, 0}, {1, 1, 2}, {1, 1, 2}}});
}
std::string bar_toml(const std::string& more) {
  return "[mesh]\nfile = \"case.geo\"\norder = 1\n" + body("bar", E, 0.3, A, n) + support("bar_x0", "x") +
         support("bar_y0", "y") + support("bar_z0", "z") + more + probe("creep", "creep_strain_zz", "body = \"bar\"") +
         probe("stress", "stress_zz", "body = \"bar\"");
}
std::string tension(const std::string& value) {
  return "[[loads]]\non = \"bar_z1\"\ntraction = [0, 0, " + value + "]\n";
}

void expect_step_ends(const Outcome& outcome, const std::vector<double>& breakpoints) {
  const std::vector<double> times = outcome.steps.times();
  for (const double t : breakpoints) EXPECT_EQ(std::count(times.begin(), times.end(), t), 1) << "t = " << t;
}

/// An integrator that sees a jump ahead creeps up to it with ever shorter steps. (A step or two is rejected
/// where a method begins anew and looks for its step, with or without a jump: these do not count.)
void expect_no_crowd_before(const Outcome& outcome, const std::vector<double>& jumps) {
  double begin = 0;
  for (const double t : jumps) {
    const std::vector<double> times = outcome.steps.times();
    EXPECT_LE(
        std::count_if(times.begin(), times.end(), [&](double end) { return end > t - 0.05 * (t - begin) && end <= t; }),
        5)
        << "t = " << t;
    begin = t;
  }
}

/// Stress 100, 200, 0, -100 from 0, 10, 20, 30 on: constant rates between the jumps, and the strain at a jump is known
/// to rounding. An output time at a jump has the stress after it.
void expect_stepped_stress(const Outcome& outcome, double tolerance) {
  const double slow = A * std::pow(100, n), fast = A * std::pow(200, n);
  const std::vector<std::array<double, 3>> expected{{0, 0, 100},
                                                    {5, 5 * slow, 100},
                                                    {10, 10 * slow, 200},
                                                    {20, 10 * slow + 10 * fast, 0},
                                                    {25, 10 * slow + 10 * fast, 0},
                                                    {30, 10 * slow + 10 * fast, -100},
                                                    {40, 10 * fast, -100}};
  const double largest = 10 * (slow + fast);
  for (const auto& [t, creep, stress] : expected) {
    EXPECT_NEAR(outcome.history.at("creep", t), creep, tolerance * largest) << "t = " << t;
    EXPECT_NEAR(outcome.history.at("stress", t), stress, 1e-8 * 200) << "t = " << t;
  }
  expect_step_ends(outcome, {10, 20, 30, 40});
}

TEST(Jumps, OfTheStressOnABar) {
  const std::string table = "{ t = [0, 10, 10, 20, 20, 30, 30, 40], values = [100, 100, 200, 200, 0, 0, -100, -100] }";
  const std::string time = "[time]\nend = 40\nstep = 1.3\noutput = [5, 10, 20, 25, 30]\n";
  for (const std::string& integrator : integrators) {
    SCOPED_TRACE(integrator);
    const Outcome outcome = run_case(bar_toml(tension(table) + time), bar_geo(), {"time.integrator=" + integrator});
    expect_stepped_stress(outcome, 1e-9);
    EXPECT_EQ(outcome.summary.number("rejected_steps"), 0);
    if (!integrator.ends_with("_euler")) {
      EXPECT_LT(outcome.summary.number("steps"), 80);
    }
  }
}

/// Expressions may be written with < or with <=.
TEST(Jumps, OfExpressionsAtNamedBreakpoints) {
  const std::string time = "[time]\nend = 40\noutput = [5, 10, 20, 25, 30]\nbreakpoints = [10, 20, 30]\n";
  for (const std::string sign : {"<", "<="}) {
    SCOPED_TRACE(sign);
    const std::string value = fmt::format("\"t {0} 10 ? 100 : (t {0} 20 ? 200 : (t {0} 30 ? 0 : -100))\"", sign);
    const Outcome outcome = run_case(bar_toml(tension(value) + time), bar_geo());
    expect_stepped_stress(outcome, 1e-9);
    EXPECT_EQ(outcome.summary.number("rejected_steps"), 0);
  }
}

/// A jump at the very end shows in the last row and in nothing that was integrated; one at the start is past.
TEST(Jumps, AtBothEndsOfTheRun) {
  const std::string table = "{ t = [0, 0, 10, 10], values = [500, 100, 100, 300] }";
  for (const std::string& integrator : integrators) {
    SCOPED_TRACE(integrator);
    const Outcome outcome = run_case(bar_toml(tension(table) + "[time]\nend = 10\nstep = 1.3\n"), bar_geo(),
                                     {"time.integrator=" + integrator});
    EXPECT_NEAR(outcome.history.at("stress", 0), 100, 1e-8);
    EXPECT_NEAR(outcome.history.at("stress", 10), 300, 1e-8);
    EXPECT_RELATIVE(outcome.history.at("creep", 10), 10 * A * std::pow(100, n), 1e-9);
  }
}

/// A pulse that is over before the next output time.
TEST(Jumps, APulseBetweenOutputs) {
  const std::string table = "{ t = [10, 10, 10.5, 10.5], values = [0, 300, 300, 0] }";
  for (const std::string& integrator : integrators) {
    SCOPED_TRACE(integrator);
    const Outcome outcome = run_case(bar_toml(tension(table) + "[time]\nend = 100\nstep = 1.3\noutput = [5, 50]\n"),
                                     bar_geo(), {"time.integrator=" + integrator});
    EXPECT_EQ(outcome.history.at("creep", 5), 0);
    for (const double t : {50.0, 100.0})
      EXPECT_RELATIVE(outcome.history.at("creep", t), 0.5 * A * std::pow(300, n), 1e-9);
    expect_step_ends(outcome, {10, 10.5, 100});
  }
}

/// Without creep the history is a sequence of elastic states.
TEST(Jumps, OfAnElasticBar) {
  const std::string table = "{ t = [0, 10, 10, 20], values = [100, 100, 200, 0] }";
  const Outcome outcome = run_case(bar_toml(tension(table) + "[time]\nend = 20\noutput = [9.9, 10, 15]\n"), bar_geo(),
                                   {"materials.bar.creep=[]"});
  for (const auto& [t, stress] : std::vector<std::pair<double, double>>{{9.9, 100}, {10, 200}, {15, 100}, {20, 0}})
    EXPECT_NEAR(outcome.history.at("stress", t), stress, 1e-8) << t;
}

/// Stress of a bar held at its length, from `stress` on.
double relaxed(double stress, double seconds, double compliance) {
  return std::copysign(std::pow(std::pow(std::abs(stress), 1 - n) + (n - 1) * A / compliance * seconds, 1 / (1 - n)),
                       stress);
}

/// A bar held at its length: its temperature jumps from 20 to 120, relaxes, jumps back.
TEST(Jumps, OfTheTemperatureOfAClampedBar) {
  const double jump = E * 1e-5 * 100;
  const std::string clamp = support("bar_z1", "z") +
                            "[temperature]\nvalue = { t = [0, 50, 50, 150, 150, 200], values = [20, 20, 120, 120, 20, "
                            "20] }\n[time]\nend = 200\ntolerance = 1e-6\noutput = [49, 50, 100, 150]\n";
  const double before = relaxed(-jump, 100, 1 / E);
  for (const char* integrator : {"cvode_bdf", "arkode_dirk", "arkode_erk"}) {
    SCOPED_TRACE(integrator);
    const Outcome outcome =
        run_case(bar_toml(clamp + probe("T", "temperature", "body = \"bar\"")), bar_geo(),
                 {std::string("time.integrator=") + integrator, "materials.bar.thermal_expansion=1e-5",
                  "materials.bar.reference_temperature=20"});
    const Table& history = outcome.history;
    EXPECT_NEAR(history.at("stress", 49), 0, 1e-9);
    EXPECT_NEAR(history.at("stress", 50), -jump, 1e-8 * jump);
    EXPECT_EQ(history.at("T", 50), 120);
    EXPECT_NEAR(history.at("stress", 100), relaxed(-jump, 50, 1 / E), 1e-5 * jump);
    EXPECT_NEAR(history.at("stress", 150), before + jump, 1e-5 * jump);
    EXPECT_EQ(history.at("T", 150), 20);
    EXPECT_NEAR(history.at("stress", 200), relaxed(before + jump, 50, 1 / E), 1e-5 * jump);
    expect_no_crowd_before(outcome, {50, 150});
    expect_step_ends(outcome, {50, 150, 200});
  }
}

std::string blocks_geo() {
  return boxes_geo({{"lower", {0, 0, 0}, {1, 1, 2}, {2, 2, 2}}, {"upper", {0, 0, 2}, {1, 1, 2}, {3, 3, 2}}});
}
std::string blocks_toml(const std::string& more) {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 1\n" + body("lower", E, 0.3, A, n) + body("upper", E, 0.3) +
                     support("lower_z0", "z") + probe("p", "contact_pressure", "on = \"lower_z1\"") +
                     probe("reaction", "reaction_z", "on = \"lower_z0\"") +
                     probe("force", "contact_force_z", "on = \"upper_z0\"");
  for (const char* name : {"lower", "upper"})
    toml += support(std::string(name) + "_x0", "x") + support(std::string(name) + "_y0", "y");
  return toml + more;
}

/// Two blocks pressed and held; a shim between them is pulled out and driven in again.
TEST(Jumps, OfAContactGap) {
  constexpr double compliance = 4 / E, creeping = 2, pressed = 2.0e-3, shim = 1.0e-3;
  const std::string toml =
      blocks_toml(support("upper_z1", "z", "-2e-3") +
                  contact_table("lower_z1", "upper_z0",
                                "gap = { t = [0, 40, 40, 90, 90, 100], values = [0, 0, 1e-3, 1e-3, 0, 0] }") +
                  "[time]\nend = 150\ntolerance = 1e-6\noutput = [40, 90]\n");
  const double first = relaxed(pressed / compliance, 40, compliance / creeping);
  const double second = first - shim / compliance;
  ASSERT_GT(second, 0) << "else the blocks would part";
  const double third = relaxed(second, 50, compliance / creeping) + shim / compliance;
  for (const char* integrator : {"cvode_bdf", "arkode_dirk", "arkode_erk"}) {
    SCOPED_TRACE(integrator);
    const Outcome outcome = run_case(toml, blocks_geo(), {std::string("time.integrator=") + integrator});
    EXPECT_NEAR(outcome.history.at("p", 40), second, 1e-5 * first);
    EXPECT_NEAR(outcome.history.at("p", 90), third, 1e-5 * first);
    EXPECT_NEAR(outcome.history.at("p", 150), relaxed(third, 60, compliance / creeping), 1e-5 * first);
    expect_no_crowd_before(outcome, {40, 90});
    expect_step_ends(outcome, {40, 90, 100, 150});
  }
}

/// Output times force no steps, and an interpolated state is brought back to equilibrium.
TEST(Outputs, BetweenStepsAreInEquilibriumAndCostNone) {
  const std::string toml = blocks_toml("[[loads]]\non = \"upper_z1\"\npressure = \"50 + 0.5*t\"\n" +
                                       contact_table("lower_z1", "upper_z0") + "[time]\nend = 100\nstep = 7\n");
  for (const std::string& integrator : integrators) {
    SCOPED_TRACE(integrator);
    const std::string choice = "time.integrator=" + integrator;
    const Outcome few = run_case(toml, blocks_geo(), {choice});
    const Outcome many = run_case(toml, blocks_geo(), {choice, "time.output={ count = 37 }"});
    EXPECT_EQ(many.steps.times(), few.steps.times());
    ASSERT_EQ(many.history.rows(), 38);
    for (const double t : many.history.times()) {
      const double load = 50 + 0.5 * t;
      EXPECT_RELATIVE(many.history.at("reaction", t), load, 1e-9);
      EXPECT_RELATIVE(many.history.at("force", t), load, 1e-9);
      EXPECT_RELATIVE(many.history.at("p", t), load, 1e-9);
    }
  }
}

}  // namespace
}  // namespace jumps_tests
}  // namespace creepcontact::test
