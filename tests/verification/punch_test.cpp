/// Flat punches with a sharp edge, almost rigid, on a half space: the pressure up to near the edge, and its smoothness.

#include "verification/reference/punch.hpp"

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/half_space.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace punch_tests {
namespace {

using test::HalfSpace;

constexpr double punch_modulus = 1e4;  // that of the half space is 1

/// Error of the pressure relative to the exact one by the distance from the centre (the half width is 1).
using Profile = std::map<double, double>;

double largest(const Profile& profile) {
  double result = 0;
  for (const auto& [x, error] : profile) result = std::max(result, std::abs(error));
  return result;
}

/// Largest distance of an error from the middle of its neighbours': noise from node to node doubles in it, the smooth
/// error of the mesh all but vanishes.
double roughness(const Profile& profile) {
  std::vector<double> errors;
  for (const auto& [x, error] : profile) errors.push_back(error);
  double result = 0;
  for (std::size_t i = 1; i + 1 < errors.size(); ++i)
    result = std::max(result, std::abs(errors[i] - 0.5 * (errors[i - 1] + errors[i + 1])));
  return result;
}

std::string press(const std::string& slave) {
  return test::support("punch_x0", "x") + test::support("punch_y0", "y") + test::support("punch_z1", "z", "-0.01") +
         test::contact_table("punch_z0", "base_patch", "slave = \"" + slave + "\"") + "[time]\nend = 1\n" +
         test::probe("force", "contact_force_z", "on = \"punch_z0\"") +
         test::probe("area", "contact_area", "on = \"punch_z0\"");
}

struct Case {
  std::string name, slave;
  int order, fine, along;  // elements over 1.5 half widths of the base, and along the punch
  double error, roughness;
};

class PlanePunch : public testing::TestWithParam<Case> {};

TEST_P(PlanePunch, PressureIsSmoothAndExactAwayFromTheEdge) {
  const Case& tested = GetParam();
  const double width = 0.1;
  const HalfSpace base{"base", 0, -1, 1.5, tested.fine, 30, 10, 12, width};
  const std::vector<test::Box> punch{{"punch", {0, 0, 0}, {1, width, 1}, {tested.along, 1, 4}}};
  const test::ContactState state = test::contact_state(
      "[mesh]\nfile = \"case.geo\"\n" + test::body("base", 1, 0.3) + test::body("punch", punch_modulus, 0.3) +
          test::half_space_supports(base, 0) + test::support("punch_y1", "y") + press(tested.slave),
      test::boxes_geo(punch) + test::half_space_geo(base), {"mesh.order=" + std::to_string(tested.order)});
  EXPECT_RELATIVE(state.probes.at("area"), width, 1e-9);
  Profile profile;
  for (const test::ContactPoint& point : state.pairs.begin()->second) {
    const double x = point.position.x();
    EXPECT_GE(point.pressure, 0);
    if (x < 0.8 && point.position.y() == 0)
      profile[x] = point.pressure / reference::flat_punch(2 * state.probes.at("force") / width, 1, x) - 1;
  }
  EXPECT_LT(largest(profile), tested.error);
  EXPECT_LT(roughness(profile), tested.roughness);
}

INSTANTIATE_TEST_SUITE_P(Cases, PlanePunch,
                         testing::Values(Case{"quadratic_matching_edge", "auto", 2, 24, 10, 0.005, 0.002},
                                         Case{"quadratic_edge_within_element", "auto", 2, 28, 20, 0.005, 0.002},
                                         Case{"quadratic_punch_slave", "punch_z0", 2, 28, 20, 0.01, 0.005},
                                         Case{"linear_matching_edge", "auto", 1, 24, 10, 0.03, 0.003}),
                         [](const auto& parameter) { return parameter.param.name; });

class RoundPunch : public testing::TestWithParam<std::string> {};

TEST_P(RoundPunch, PressureIsExactAwayFromTheEdge) {
  const HalfSpace base{"base", 0, -1, 1.2, 12, 15, 6, 8};
  const std::string punch = R"geo(
    Cylinder(1) = {0, 0, 0, 0, 0, 1, 1, Pi/2};
    MeshSize{ PointsOf{ Volume{1}; } } = 0.15;
    Physical Volume("punch") = {1};
    Physical Surface("punch_z0") = Surface In BoundingBox{-0.1, -0.1, -1e-4, 1.1, 1.1, 1e-4};
    Physical Surface("punch_z1") = Surface In BoundingBox{-0.1, -0.1, 1 - 1e-4, 1.1, 1.1, 1 + 1e-4};
    Physical Surface("punch_x0") = Surface In BoundingBox{-1e-4, -0.1, -0.1, 1e-4, 1.1, 1.1};
    Physical Surface("punch_y0") = Surface In BoundingBox{-0.1, -1e-4, -0.1, 1.1, 1e-4, 1.1};
  )geo";
  const test::ContactState state = test::contact_state(
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("base", 1, 0.3) +
          test::body("punch", punch_modulus, 0.3) + test::half_space_supports(base, 0) + press(GetParam()),
      "SetFactory(\"OpenCASCADE\");\n" + punch + test::half_space_geo(base));
  EXPECT_RELATIVE(state.probes.at("area"), std::numbers::pi / 4, 1e-3);
  double worst = 0, sum = 0, area = 0;
  for (const test::ContactPoint& point : state.pairs.begin()->second) {
    const double r = point.position.head<2>().norm();
    EXPECT_GE(point.pressure, 0);
    if (r > 0.8) continue;
    const double error = point.pressure / reference::round_punch(4 * state.probes.at("force"), 1, r) - 1;
    worst = std::max(worst, std::abs(error));
    sum += point.area * error * error;
    area += point.area;
  }
  const bool automatic = GetParam() == "auto";
  EXPECT_LT(worst, automatic ? 0.04 : 0.06);
  EXPECT_LT(std::sqrt(sum / area), automatic ? 0.01 : 0.025);
}

INSTANTIATE_TEST_SUITE_P(Slave, RoundPunch, testing::Values("auto", "punch_z0"),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace punch_tests
}  // namespace creepcontact
