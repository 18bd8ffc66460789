/// A load path that turns: the direction of slip turns with it, whatever the steps.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_path_cases {
namespace {

/// A small block pressed on a softer foot; its upper end goes once round a circle, and the contact slips.
struct Circle {
  double mean, largest;  ///< slip
  double x, y;           ///< force
  double steps;
};

Circle turn(double creep, const std::string& time, const std::vector<std::string>& overrides = {}) {
  constexpr double way = 0.03;
  const std::string angle = fmt::format("{:.17g}*t", 2 * std::numbers::pi);
  const test::Outcome outcome = test::run_case(
      "[mesh]\nfile = \"case.geo\"\norder = 1\n" + test::body("foot", 100, 0.3, creep, 3) +
          test::body("block", 200, 0.3, creep / 4, 3) + test::support("foot_z0", "x") + test::support("foot_z0", "y") +
          test::support("foot_z0", "z") + test::support("block_z1", "z", "-0.02") +
          test::support("block_z1", "x", fmt::format("\"{}*sin({})\"", way, angle)) +
          test::support("block_z1", "y", fmt::format("\"{}*(1 - cos({}))\"", way, angle)) +
          test::contact_table("block_z0", "foot_z1", "friction = 0.3") + "[time]\nend = 1\n" + time +
          test::probe("mean", "slip", "on = \"foot_z1\"") +
          test::probe("largest", "slip", "on = \"foot_z1\"\nreduce = \"max\"") +
          test::probe("x", "contact_force_x", "on = \"foot_z1\"") +
          test::probe("y", "contact_force_y", "on = \"foot_z1\""),
      test::boxes_geo(
          {{"foot", {0, 0, -1}, {1, 1, 1}, {4, 4, 2}}, {"block", {0.2, 0.2, 0}, {0.6, 0.6, 0.5}, {3, 3, 2}}}),
      overrides);
  const test::Table& history = outcome.history;
  return {history.at("mean", 1), history.at("largest", 1), history.at("x", 1), history.at("y", 1),
          outcome.summary.number("steps")};
}

/// Each figure relative to the reference, slips and forces by their sizes.
double error(const Circle& found, const Circle& exact) {
  const double force = std::hypot(exact.x, exact.y);
  return std::max({std::abs(found.mean / exact.mean - 1), std::abs(found.largest / exact.largest - 1),
                   std::abs(found.x - exact.x) / force, std::abs(found.y - exact.y) / force});
}

std::string even_steps(int steps) {
  return fmt::format("output = {{ first = {:.17g}, count = {}, spacing = \"linear\" }}\n", 1.0 / steps, steps);
}

// Between outputs and breakpoints the path is followed, along loads that are not linear in time.
TEST(FrictionCircle, ElasticStepsFollowTheCircle) {
  const Circle exact = turn(0, even_steps(256));
  EXPECT_GT(exact.mean, 0.03) << "much of the way slips";
  for (const int steps : {2, 4, 16}) EXPECT_LT(error(turn(0, even_steps(steps)), exact), 1e-3) << steps;
}

// Substeps are longer where the flexibility is an operator.
TEST(FrictionCircle, ContactSolversAgree) {
  const Circle dense = turn(0, even_steps(16)), iterated = turn(0, even_steps(16), {"contact_solver.dense_limit_mb=0"});
  EXPECT_LT(error(iterated, dense), 5e-5);
}

constexpr double creep = 1e-4;

class CreepingCircle : public testing::Test {
 protected:
  static const Circle& exact() {
    static const Circle found = turn(creep, "integrator = \"cvode_adams\"\ntolerance = 1e-8\n");
    return found;
  }
};

TEST_F(CreepingCircle, FixedStepsFollowTheCircle) {
  EXPECT_GT(std::abs(exact().x / turn(0, even_steps(64)).x - 1), 0.1) << "creep counts";
  const auto with = [&](int steps) {
    return error(
        turn(creep,
             fmt::format("integrator = \"beta_euler\"\nbeta = 0.5\ninner = \"newton\"\nstep = {:.17g}\n", 1.0 / steps)),
        exact());
  };
  const double coarse = with(16), fine = with(64);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, 3e-4);
}

TEST_F(CreepingCircle, ErrorFollowsTheTolerance) {
  for (const char* integrator : {"integrator = \"cvode_adams\"", "integrator = \"cvode_bdf\"",
                                 "integrator = \"arkode_erk\"", "integrator = \"arkode_dirk\"",
                                 "integrator = \"beta_euler\"\nbeta = 0.5\nstep = \"adaptive\"\ninner = \"newton\""}) {
    const auto with = [&](double tolerance) {
      return turn(creep, fmt::format("{}\ntolerance = {}\n", integrator, tolerance));
    };
    const Circle coarse = with(1e-4), fine = with(1e-6);
    EXPECT_LT(error(coarse, exact()), 3e-3) << integrator;
    EXPECT_LT(error(fine, exact()), 1.5e-4) << integrator;
    EXPECT_LT(coarse.steps, 150) << integrator;  // the extrema of the path are breakpoints: no restart from tiny steps
  }
}

}  // namespace
}  // namespace friction_path_cases
}  // namespace creepcontact
