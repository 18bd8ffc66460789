/// The limits of what friction holds: a block that is pushed, a wedge that locks.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_limit_cases {
namespace {

constexpr double friction = 0.3;

std::string load(const std::string& on, const std::string& keys) {
  return fmt::format("[[loads]]\non = \"{}\"\n{}\n", on, keys);
}

struct Pushed {
  std::string toml, geo;
};

/// A block that rests on a foot, with nothing but friction against the push. @param part  of the limit, at t = 1
Pushed block(const std::string& analysis, double part) {
  const double push = part * friction;
  if (analysis == "solid")
    return {"[mesh]\nfile = \"case.geo\"\norder = 1\n" + test::body("foot", 1000, 0.3) + test::body("block", 500, 0.3) +
                test::support("foot_z0", "x") + test::support("foot_z0", "y") + test::support("foot_z0", "z") +
                test::contact_table("block_z0", "foot_z1", fmt::format("friction = {}", friction)) +
                load("block_z1", "pressure = 1") + load("block_z1", fmt::format("traction = [\"{}*t\", 0, 0]", push)) +
                test::probe("x", "contact_force_x", "on = \"block_z0\""),
            test::boxes_geo(
                {{"foot", {0, 0, -1}, {2, 2, 1}, {6, 6, 2}}, {"block", {0.3, 0.4, 0}, {1.4, 1.2, 0.2}, {5, 4, 2}}})};
  return {test::section_of(analysis) + test::body("foot", 1000, 0.3) + test::body("block", 500, 0.3) +
              test::support("foot_y0", "x") + test::support("foot_y0", "y") +
              test::contact_table("block_y0", "foot_y1", fmt::format("friction = {}", friction)) +
              load("block_y1", "pressure = 1") + load("block_y1", fmt::format("traction = [\"{}*t\", 0, 0]", push)) +
              test::probe("x", "contact_force_x", "on = \"block_y0\""),
          test::regions_geo({{"foot", {0, 2, 7}, {-1, 0, 4}}, {"block", {0.3, 1.7, 5}, {0, 0.2, 2}}})};
}

struct BlockCase {
  std::string analysis;
  double below, above;  ///< parts of the limit
};

class PushedBlock : public testing::TestWithParam<BlockCase> {};

TEST_P(PushedBlock, HoldsBelowTheLimitAndSlidesOffAbove) {
  const auto& [analysis, below, above] = GetParam();
  const double area = analysis == "solid" ? 1.4 * 1.2 : 1.4;
  const std::string time = "[time]\nend = 1\noutput = [0.5]\n";
  const Pushed held = block(analysis, below), lost = block(analysis, above);
  const test::Table history = test::run_case(held.toml + time, held.geo).history;
  EXPECT_RELATIVE(history.at("x", 1), -below * friction * area, 1e-8);

  const test::Outcome failed = test::run_to_failure(lost.toml + time, lost.geo);
  EXPECT_EQ(failed.exit_status, 3);
  EXPECT_EQ(failed.summary.text("status"), "failed");
  EXPECT_EQ(failed.history.times().back(), 0.5);
  EXPECT_TRUE(test::says(failed.message, {"body 'block'", "translation", " x", fmt::format("t = {:.3f}", 1 / above)}));
}

INSTANTIATE_TEST_SUITE_P(Cases, PushedBlock,
                         testing::Values(BlockCase{"plane_strain", 0.999, 1.001},
                                         BlockCase{"plane_stress", 0.999, 1.001}, BlockCase{"solid", 0.999, 1.001}),
                         [](const auto& of) { return of.param.analysis; });

/// Half of a wedge between two walls whose faces are inclined by the angle against its axis.
std::string wedge_geo(double tangent) {
  const auto quadrilateral = [](const std::string& name, const std::array<std::array<double, 2>, 4>& corners,
                                int across, int along) {
    std::string geo = "p = newp; l = newl; k = newll; s = news;\n";
    for (std::size_t i = 0; i < 4; ++i)
      geo += fmt::format("Point(p + {}) = {{{:.15g}, {:.15g}, 0}};\n", i, corners[i][0], corners[i][1]);
    return geo + fmt::format(R"(
      Line(l) = {{p, p + 1}}; Line(l + 1) = {{p + 1, p + 2}}; Line(l + 2) = {{p + 3, p + 2}}; Line(l + 3) = {{p, p + 3}};
      Transfinite Curve{{l, l + 2}} = {1} + 1; Transfinite Curve{{l + 1, l + 3}} = {2} + 1;
      Curve Loop(k) = {{l, l + 1, -(l + 2), -(l + 3)}}; Plane Surface(s) = {{k}};
      Transfinite Surface{{s}} = {{p, p + 1, p + 2, p + 3}}; Recombine Surface{{s}};
      Physical Surface("{0}") = {{s}}; Physical Curve("{0}_right") = {{l + 1}};
      Physical Curve("{0}_top") = {{l + 2}}; Physical Curve("{0}_left") = {{l + 3}};
    )",
                             name, across, along);
  };
  return "SetFactory(\"OpenCASCADE\");\n" + quadrilateral("wedge", {{{0, 0}, {1, 0}, {1 + tangent, 1}, {0, 1}}}, 5, 5) +
         quadrilateral("wall", {{{1 - tangent / 2, -0.5}, {4, -0.5}, {4, 1.5}, {1 + 1.5 * tangent, 1.5}}}, 8, 14);
}

struct WedgeResult {
  test::Table history;
  double kappa;
  std::string warnings;
};

/// Pressed in until t = 1; then the pressure goes back to a thousandth until t = 2.
WedgeResult wedge(double tangent, double coefficient) {
  testing::internal::CaptureStderr();
  const test::Outcome outcome = test::run_case(
      test::section_of("plane_strain") + test::body("wedge", 1000, 0.3) + test::body("wall", 1000, 0.3) +
          test::support("wedge_left", "x") + test::support("wall_right", "x") + test::support("wall_right", "y") +
          test::contact_table("wedge_right", "wall_left", fmt::format("friction = {}", coefficient)) +
          load("wedge_top", "pressure = { t = [0, 1, 2], values = [0, 1, 0.001] }") +
          "[time]\nend = 2\noutput = [1, 1.5, 1.8, 1.9, 1.94, 1.96, 1.98, 1.99, 1.995]\n" +
          test::probe("x", "contact_force_x", "on = \"wedge_right\"") +
          test::probe("y", "contact_force_y", "on = \"wedge_right\""),
      wedge_geo(tangent));
  return {outcome.history, outcome.summary.number("friction_kappa"), testing::internal::GetCapturedStderr()};
}

/// On the faces friction holds against the normal force if its coefficient exceeds the tangent of the angle.
TEST(Wedge, LocksAboveTheTangentOfItsAngle) {
  const double angle = std::numbers::pi / 12, tangent = std::tan(angle), pressed = 1 + tangent;
  for (const double part : {0.75, 0.95}) {
    const WedgeResult free = wedge(tangent, part * tangent);
    EXPECT_RELATIVE(free.kappa, part, 0.005);
    EXPECT_EQ(free.warnings.find("kappa"), std::string::npos) << free.warnings;
    // On the way out all of the face slips: the horizontal force that belongs to the rest of the vertical one.
    const double force = 0.001 * pressed;
    EXPECT_RELATIVE(free.history.at("y", 2), force, 1e-6);
    EXPECT_RELATIVE(-free.history.at("x", 2), force / std::tan(angle - std::atan(part * tangent)), 1e-6);
  }
  const WedgeResult locked = wedge(tangent, 0.5);
  EXPECT_RELATIVE(locked.kappa, 0.5 / tangent, 0.005);
  EXPECT_NE(locked.warnings.find("kappa = 1.86"), std::string::npos) << locked.warnings;
  EXPECT_GT(locked.history.at("x", 2) / locked.history.at("x", 1), 0.9) << "the walls still press";
}

}  // namespace
}  // namespace friction_limit_cases
}  // namespace creepcontact
