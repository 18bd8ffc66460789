/// Joints whose conductance depends on their pressure and gap: the temperature is part of the state of the run.

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/run/check.hpp"
#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/interrupted.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace coupled_heat_tests {
namespace {

using namespace test;

constexpr double side = 1e-4;

std::string conducting(const std::string& name, double expansion, double young_modulus = 200e9, double A = 0) {
  std::string toml = body(name, young_modulus, 0, A, 5);
  const std::string before = "poisson_ratio = 0\n";
  return toml.insert(toml.find(before) + before.size(),
                     fmt::format("conductivity = 40\nheat_capacity = 500\ndensity = 8000\nthermal_expansion = {}\n"
                                 "reference_temperature = 0\n",
                                 expansion));
}

/// A rod of 0.1 m, so thin that it is straight, held and kept at 0 at one end; it grows towards a wall that is hot and
/// does not give way. All in m, N, s.
const std::string rod_geo =
    boxes_geo({{"rod", {0, 0, 0}, {side, side, 0.1}, {1, 1, 8}}, {"wall", {0, 0, 0.1}, {side, side, 1e-3}, {1, 1, 2}}});

/// @param gap  up to the wall @param A  of its creep
std::string rod(const std::string& heat, double gap, const std::string& rest, double A = 0) {
  std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + conducting("rod", 1.2e-5, 200e9, A) + conducting("wall", 0, 1e20) +
      "[heat]\ntime_unit = 1\n" + heat +
      "temperatures = [{ on = \"rod_z0\", value = 0 }, { on = \"wall_z0\", value = 300 }, "
      "{ on = \"wall_z1\", value = 300 }]\n" +
      contact_table("rod_z1", "wall_z0",
                    fmt::format("gap = {}\nconductance = \"200/(1 + gap/20e-6) + 5000*(p/10e6)^0.95\"", gap));
  for (const std::string name : {"rod", "wall"}) toml += support(name + "_x0", "x") + support(name + "_y0", "y");
  toml += support("rod_z0", "z") + support("wall_z0", "z") + support("wall_z1", "z");
  return toml + rest + probe("p", "contact_pressure", "on = \"rod_z1\"") + probe("gap", "gap", "on = \"rod_z1\"") +
         probe("end", "temperature", fmt::format("at = [0, 0, 0.1]\nbody = \"rod\""));
}

const std::string long_enough = "[time]\nend = 1e5\ntolerance = 1e-4\n";

/// T_e = 300/(1 + k/(h L)), and p = E (alpha T_e/2 - g0/L) or the gap that is left, have three solutions for a gap of
/// 80e-6, of which the middle one is unstable, and one for 50e-6.
TEST(CoupledHeat, ReachesTheStatesOfARodThatGrowsTowardsAWall) {
  const Table cold = run_case(rod("start = 0\n", 80e-6, long_enough), rod_geo).history;
  EXPECT_RELATIVE(cold.at("gap", 1e5), 60e-6, 1e-3);
  EXPECT_RELATIVE(cold.at("end", 1e5), 33.33333, 1e-4);
  const Table hot = run_case(rod("start = 300\n", 80e-6, long_enough), rod_geo).history;
  EXPECT_RELATIVE(hot.at("p", 1e5), 198.32567e6, 1e-3);
  EXPECT_RELATIVE(hot.at("end", 1e5), 298.6047, 1e-4);
  const Table narrow = run_case(rod("start = 0\n", 50e-6, long_enough), rod_geo).history;
  EXPECT_RELATIVE(narrow.at("p", 1e5), 258.69720e6, 1e-3);
}

TEST(CoupledHeat, FindsASteadyStateAtTheStart) {
  const Outcome outcome = run_case(rod("start = \"steady\"\n", 80e-6, "[time]\nend = 0\n"), rod_geo);
  EXPECT_RELATIVE(outcome.history.at("gap", 0), 60e-6, 1e-5);
  EXPECT_RELATIVE(outcome.history.at("end", 0), 33.33333, 1e-6);
  EXPECT_GT(outcome.summary.number("heat/loop_gain"), 0.1);
}

/// Creep takes the pressure away, and with it the conductance: the states of coarse tolerances agree with fine ones.
TEST(CoupledHeat, ConvergesWithTheTolerance) {
  const auto end = [&](const std::string& tolerance, const std::string& integrator) {
    const Outcome outcome =
        run_case(rod("start = 300\n", 80e-6,
                     "[time]\nend = 1e6\ntolerance = " + tolerance + "\nintegrator = \"" + integrator + "\"\n", 3e-51),
                 rod_geo);
    return std::pair(outcome.history.at("p", 1e6), outcome.history.at("end", 1e6));
  };
  const auto [p, T] = end("1e-5", "cvode_bdf");
  const auto [p_hot, T_hot] = std::pair(198.32567e6, 298.6047);
  EXPECT_LT(p, 0.8 * p_hot);
  EXPECT_LT(T, T_hot);
  for (const std::string integrator : {"auto", "arkode_dirk"}) {
    const auto [p_coarse, T_coarse] = end("1e-3", integrator);
    EXPECT_RELATIVE(p_coarse, p, 3e-3) << integrator;
    EXPECT_NEAR(T_coarse, T, 0.05) << integrator;
  }
}

/// dp/dh dh/dp with T_e = 300/(1 + k/(h L)), p = E (alpha T_e/2 - g0/L).
TEST(CoupledHeat, CheckTellsTheLoopGainOfASteadyStart) {
  const double p = 258.69720e6, h = 200 + 5000 * std::pow(p / 10e6, 0.95), flow = 1 + 400 / h;
  const double gain =
      200e9 * 1.2e-5 / 2 * 300 * 400 / (h * h) / (flow * flow) * 5000 * 0.95 * std::pow(p / 10e6, -0.05) / 10e6;
  const CaseDirectory directory(rod_geo);
  std::ostringstream text;
  run::check(directory.config(rod("start = \"steady\"\n", 50e-6, "[time]\nend = 1\n"), {}), text, {.start = true});
  const std::string all = text.str(), before = "loop gain of contact and heat: ";
  const std::size_t at = all.find(before);
  ASSERT_NE(at, std::string::npos) << all;
  EXPECT_NEAR(std::stod(all.substr(at + before.size())), gain, 0.02 * gain);  // two digits are written
  EXPECT_TRUE(says(all, {"steady heat", "given temperature of 'rod_z0'", "across contact", "balance: "}));
  EXPECT_TRUE(says(all, {"normal force 2.587, peak pressure 2.59e+08"}));
}

/// The wall is cooled and heated: events lie where the temperatures of a finer run cross their limits.
TEST(CoupledHeat, GoesThroughCyclesAndFindsEvents) {
  std::string toml =
      rod("start = 0\n", 50e-6,
          "[time]\nend = 60000\noutput = [10000, 30000, 50000]\ncycle = 20000\ntolerance = 1e-4\n", 1e-51);
  for (std::size_t at = 0; (at = toml.find("value = 300", at)) != std::string::npos; ++at)
    toml.replace(at, 11,
                 "value = { t = [0, 1000, 10000, 11000, 20000], values = [0, 300, 300, 0, 0], period = 20000 }");
  toml += "[[events]]\nname = \"warm\"\nwhen = \"end >= 150\"\n";
  toml += "[[events]]\nname = \"loose\"\nwhen = \"min(gap/1e-6, end/10) > 1\"\n";
  const Outcome coarse = run_case(toml, rod_geo), fine = run_case(toml, rod_geo, {"time.tolerance=1e-6"});
  for (const std::string event : {"warm", "loose"})
    EXPECT_RELATIVE(coarse.summary.number("events/" + event), fine.summary.number("events/" + event), 1e-3) << event;
  for (const double t : {10000.0, 30000.0, 50000.0}) {
    EXPECT_GT(fine.history.at("p", t), 50e6);
    EXPECT_RELATIVE(coarse.history.at("p", t), fine.history.at("p", t), 1e-3) << t;
  }
  EXPECT_GT(fine.history.at("gap", 60000), 40e-6) << "cold";
}

TEST(CoupledHeat, ResumesExactly) {
  const CaseDirectory directory(rod_geo);
  expect_same_when_resumed(
      directory.config(
          rod("start = 0\n", 50e-6, "[time]\nend = 3000\noutput = [100, 1000]\nintegrator = \"arkode_dirk\"\n", 1e-51),
          {}),
      directory.path(), {3, 17});
}

TEST(CoupledHeat, RefusesWhatItCannotDo) {
  const auto message = [](const std::string& rest, const std::string& from = "", const std::string& to = "") {
    std::string toml = rod("start = 0\n", 80e-6, rest);
    if (!from.empty()) toml.replace(toml.find(from), from.size(), to);
    return message_of<Error>([&] { run_case(toml, rod_geo); });
  };
  EXPECT_TRUE(says(message("[time]\nend = 1\nintegrator = \"log_adams\"\n"), {"time.integrator", "cvode_bdf"}));
  EXPECT_TRUE(says(message("[time]\nend = 1\nlinear_solver = \"tangent\"\n"), {"time.linear_solver", "krylov"}));
  EXPECT_TRUE(says(message("[time]\nend = 1\n", "gap = 8e-05", "gap = 8e-05\nfriction = 0.1"),
                   {"contacts[0]", "friction", "part of the state"}));
  std::string negative = rod("start = 0\n", 80e-6, "[time]\nend = 1\n");
  negative.replace(negative.find("200/"), 3, "-1");
  EXPECT_TRUE(says(run_to_failure(negative, rod_geo).message, {"conductance is -", "gap = ", "not negative"}));
  EXPECT_TRUE(says(message("[time]\nend = 1\n", "[heat]\n", "[heat]\nalone = true\n"), {"conductance", "nothing but"}));
}

}  // namespace
}  // namespace coupled_heat_tests
}  // namespace creepcontact
