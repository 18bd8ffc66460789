/// Hertz contact of spheres and cylinders on a half space: two large blocks and the parabola between them as given gap.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/half_space.hpp"
#include "verification/hertz_profile.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace hertz_tests {
namespace {

using test::HalfSpace;
using test::HertzErrors;

constexpr double curvature = 10, poisson_ratio = 0.3;

/// The lower body has the modulus 1 and `fine` elements over 1.5 contact radii, the upper one three quarters of them.
struct Case {
  bool sphere;
  double upper_modulus;
  std::string slave = "auto";
  int fine = 16;
  double extent = 15;

  std::string what() const {
    return fmt::format("{} E ratio {} slave {} fine {}", sphere ? "sphere" : "cylinder", upper_modulus, slave, fine);
  }
};

struct Result {
  HertzErrors errors;
  reference::Hertz exact;
  std::string slave;
};

/// Presses the upper body down by `pushed` and compares with the Hertz state of the resultant.
Result press(const Case& tested, double pushed) {
  const double width = tested.sphere ? 0 : 1.5 / tested.fine;
  const int coarse = tested.sphere ? 5 : 10, deep = tested.sphere ? 7 : 12;
  const HalfSpace lower{"lower", 0, -1, 1.5, tested.fine, tested.extent, coarse, deep, width};
  const HalfSpace upper{"upper", 0, 1, 1.5, tested.fine * 3 / 4, tested.extent, coarse, deep, width};
  const std::string gap = fmt::format("gap = \"(x*x{})/{}\"", tested.sphere ? " + y*y" : "", 2 * curvature);
  const test::ContactState state = test::contact_state(
      "[mesh]\nfile = \"case.geo\"\norder = 2\n[time]\nend = 1\n" + test::body("lower", 1, poisson_ratio) +
          test::body("upper", tested.upper_modulus, poisson_ratio) + test::half_space_supports(lower, 0) +
          test::half_space_supports(upper, -pushed) +
          test::contact_table("lower_patch", "upper_patch", "slave = \"" + tested.slave + "\"\n" + gap) +
          test::probe("force", "contact_force_z", "on = \"upper_patch\"") +
          test::probe("opposite", "contact_force_z", "on = \"lower_patch\"") +
          test::probe("held", "reaction_z", "on = \"lower_far\"") +
          test::probe("moved", "reaction_z", "on = \"upper_far\"") +
          test::probe("area", "contact_area", "on = \"upper_patch\""),
      "SetFactory(\"OpenCASCADE\");\n" + test::half_space_geo(lower) + test::half_space_geo(upper));
  const double force = state.probes.at("force"), area = state.probes.at("area");
  EXPECT_RELATIVE(state.probes.at("opposite"), -force, 1e-13);
  EXPECT_RELATIVE(state.probes.at("held"), force, 1e-9);
  // Rounding of the rigid part of the motion times a modulus up to a thousand times the pressures' scale.
  EXPECT_RELATIVE(state.probes.at("moved"), -force, tested.upper_modulus > 1 ? 1e-6 : 1e-9);

  const double modulus = reference::contact_modulus({1, poisson_ratio}, {tested.upper_modulus, poisson_ratio});
  const reference::Hertz exact = tested.sphere ? reference::hertz_sphere(4 * force, curvature, modulus)
                                               : reference::hertz_cylinder(2 * force / width, curvature, modulus);
  const auto& [pair, points] = *state.pairs.begin();
  const HertzErrors errors =
      test::hertz_errors(points, exact, tested.sphere ? std::sqrt(4 * area / std::numbers::pi) : area / width,
                         [&](const Vector3& x) { return tested.sphere ? x.head<2>().norm() : x.x(); });
  return {errors, exact, state.slave.at(pair)};
}

class Hertz : public testing::TestWithParam<Case> {};

TEST_P(Hertz, PressureRadiusAndResultantConverge) {
  Case tested = GetParam();
  if (!tested.sphere) tested.extent = 30;  // plane strain decays more slowly
  const double pushed = tested.sphere ? 0.11 : 0.25, rms = tested.sphere ? 0.016 : 0.01;
  const Result fine = press(tested, pushed);
  test::expect_hertz(fine.errors, rms, tested.what());
  tested.fine = 8;
  const Result coarse = press(tested, pushed);
  EXPECT_LT(fine.errors.rms, 0.5 * coarse.errors.rms);
  EXPECT_LT(std::abs(fine.errors.peak), 0.5 * std::abs(coarse.errors.peak));
}

INSTANTIATE_TEST_SUITE_P(Cases, Hertz,
                         testing::Values(Case{false, 1, "lower_patch"}, Case{false, 1, "upper_patch"}, Case{false, 1e3},
                                         Case{false, 1e-3}, Case{true, 1, "upper_patch"}, Case{true, 1e3},
                                         Case{true, 1e-3}),
                         [](const auto& parameter) {
                           const Case& tested = parameter.param;
                           return test::hertz_name(tested.sphere, tested.upper_modulus, tested.slave);
                         });

// The stiffer, finer side as slave gives pressures that are noise in part: the automatic choice must be the other one.
TEST(HertzSlave, AutomaticChoiceIsTheGoodOne) {
  const Result automatic = press({true, 1e-3, "auto", 10}, 0.11), forced = press({true, 1e-3, "lower_patch", 10}, 0.11);
  EXPECT_EQ(automatic.slave, "upper_patch");
  EXPECT_LT(automatic.errors.rms, 0.025);
  EXPECT_GT(forced.errors.rms, 4 * automatic.errors.rms);
  // The resultant is right all the same.
  EXPECT_RELATIVE(forced.exact.radius, automatic.exact.radius, 1e-3);
}

// Points far away approach each other by a^2/R. In blocks of finite size less, by a part that falls with 1/size.
TEST(HertzApproach, OfDistantPoints) {
  const double pushed = 0.11;
  std::vector<double> excess;
  for (const double extent : {15, 30}) {
    const double a = press({true, 1, "auto", 8, extent}, pushed).exact.radius;
    excess.push_back(a * a / curvature / pushed - 1);
  }
  EXPECT_NEAR(2 * excess[1] - excess[0], 0, 5e-3) << excess[0] << " " << excess[1];
  EXPECT_LT(excess[1], 0.6 * excess[0]);
}

}  // namespace
}  // namespace hertz_tests
}  // namespace creepcontact
