/// Contact of sections: Hertz (line and ball), a sharp punch, and first contact under a force.

#include <fmt/format.h>

#include <numbers>

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/hertz_profile.hpp"
#include "verification/plane_regions.hpp"
#include "verification/reference/punch.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace section_contact_cases {
namespace {

using test::HalfPlane;

constexpr double curvature = 10, poisson_ratio = 0.3;

struct HertzCase {
  std::string analysis;
  double upper_modulus;
  std::string slave;
  bool is_ball() const { return analysis == "axisymmetric"; }
};

struct Result {
  test::HertzErrors errors;
  double radius;
};

std::string half_plane_supports(const HalfPlane& block, double y) {
  return test::support(block.name + "_x0", "x") + test::support(block.name + "_far", "y", fmt::format("{}", y));
}

Result press(const HertzCase& tested, int fine) {
  const double extent = tested.is_ball() ? 15 : 30, pushed = tested.is_ball() ? 0.11 : 0.25;
  const HalfPlane lower{"lower", -1, 1.5, fine, extent, 12, 16};
  const HalfPlane upper{"upper", 1, 1.5, fine * 3 / 4, extent, 12, 16};
  const test::ContactState state = test::contact_state(
      test::section_of(tested.analysis) + "[time]\nend = 1\n" + test::body("lower", 1, poisson_ratio) +
          test::body("upper", tested.upper_modulus, poisson_ratio) + half_plane_supports(lower, 0) +
          half_plane_supports(upper, -pushed) +
          test::contact_table("lower_patch", "upper_patch",
                              fmt::format("slave = \"{}\"\ngap = \"x*x/{}\"", tested.slave, 2 * curvature)) +
          test::probe("force", "contact_force_y", "on = \"upper_patch\"") +
          test::probe("held", "reaction_y", "on = \"lower_far\"") +
          test::probe("area", "contact_area", "on = \"upper_patch\""),
      "SetFactory(\"OpenCASCADE\");\n" + test::half_plane_geo(lower) + test::half_plane_geo(upper));
  const double force = state.probes.at("force"), area = state.probes.at("area");
  EXPECT_RELATIVE(state.probes.at("held"), force, 1e-8);
  const double modulus = reference::contact_modulus({1, poisson_ratio}, {tested.upper_modulus, poisson_ratio});
  const reference::Hertz exact = tested.is_ball() ? reference::hertz_sphere(force, curvature, modulus)
                                                  : reference::hertz_cylinder(2 * force, curvature, modulus);
  return {test::hertz_errors(state.pairs.begin()->second, exact,
                             tested.is_ball() ? std::sqrt(area / std::numbers::pi) : area,
                             [](const Vector3& x) { return x.x(); }),
          exact.radius};
}

class SectionHertz : public testing::TestWithParam<HertzCase> {};

TEST_P(SectionHertz, PressureRadiusAndResultantConverge) {
  const HertzCase& tested = GetParam();
  test::expect_hertz(press(tested, 16).errors, tested.is_ball() ? 0.016 : 0.01, tested.analysis);
  // By smaller factors the error depends on where the edge of contact lies within an element.
  EXPECT_LT(press(tested, 48).errors.rms, 0.6 * press(tested, 8).errors.rms);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SectionHertz,
    testing::Values(HertzCase{"plane_strain", 1, "lower_patch"}, HertzCase{"plane_strain", 1, "upper_patch"},
                    HertzCase{"plane_strain", 1e3, "auto"}, HertzCase{"axisymmetric", 1, "lower_patch"},
                    HertzCase{"axisymmetric", 1, "upper_patch"}, HertzCase{"axisymmetric", 1e-3, "auto"}),
    [](const auto& of) {
      return fmt::format("{}_{}_{}", of.param.analysis, of.param.upper_modulus == 1 ? "alike" : "unlike",
                         of.param.slave);
    });

struct PunchCase {
  std::string analysis;
  int order, fine, along;
  double error, roughness;
};

class SectionPunch : public testing::TestWithParam<PunchCase> {};

TEST_P(SectionPunch, PressureIsSmoothAndExactAwayFromTheEdge) {
  const auto& [analysis, order, fine, along, error, roughness] = GetParam();
  const bool is_round = analysis == "axisymmetric";
  const HalfPlane base{"base", -1, 1.5, fine, is_round ? 15.0 : 30.0, 12, 16};
  const test::ContactState state = test::contact_state(
      test::section_of(analysis, order) + test::body("base", 1, 0.3) + test::body("punch", 1e4, 0.3) +
          half_plane_supports(base, 0) + test::support("punch_x0", "x") + test::support("punch_y1", "y", "-0.01") +
          test::contact_table("punch_y0", "base_patch") + "[time]\nend = 1\n" +
          test::probe("force", "contact_force_y", "on = \"punch_y0\"") +
          test::probe("area", "contact_area", "on = \"punch_y0\""),
      test::regions_geo({{"punch", {0, 1, along}, {0, 1, 4}}}) + test::half_plane_geo(base));
  const double force = state.probes.at("force");
  EXPECT_RELATIVE(state.probes.at("area"), is_round ? std::numbers::pi : 1, 1e-9);
  std::map<double, double> profile;
  for (const test::ContactPoint& point : state.pairs.begin()->second)
    if (const double x = point.position.x(); x < 0.8)
      profile[x] =
          point.pressure / (is_round ? reference::round_punch(force, 1, x) : reference::flat_punch(2 * force, 1, x)) -
          1;
  std::vector<double> errors;
  for (const auto& [x, value] : profile) {
    EXPECT_LT(std::abs(value), error) << x;
    errors.push_back(value);
  }
  for (std::size_t i = 1; i + 1 < errors.size(); ++i)
    EXPECT_LT(std::abs(errors[i] - 0.5 * (errors[i - 1] + errors[i + 1])), roughness) << i;
}

INSTANTIATE_TEST_SUITE_P(Cases, SectionPunch,
                         testing::Values(PunchCase{"plane_strain", 2, 24, 10, 0.005, 0.002},
                                         PunchCase{"plane_strain", 1, 48, 20, 0.03, 0.003},
                                         PunchCase{"axisymmetric", 2, 24, 10, 0.02, 0.006},
                                         PunchCase{"axisymmetric", 1, 48, 20, 0.03, 0.006}),
                         [](const auto& of) { return fmt::format("{}_order{}", of.param.analysis, of.param.order); });

}  // namespace
}  // namespace section_contact_cases
}  // namespace creepcontact
