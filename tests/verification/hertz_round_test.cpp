/// Hertz contact of a meshed sphere and a meshed cylinder on a block, the gap measured from the meshes or given.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/hertz_profile.hpp"
#include "verification/rings.hpp"
#include "verification/round_bodies.hpp"

namespace creepcontact {
namespace hertz_round_tests {
namespace {

using test::HertzErrors;

struct Case {
  bool sphere;
  double upper_modulus;  // the block has 1
  std::string slave;
  bool also_given_gap;  // on the flat slave the measured gap is the given one to rounding
};

struct Result {
  HertzErrors errors;
  double force;  // of the mesh, for a slice per width
};

/// How the upper body is pressed down: its flat top is displaced, or loaded and free.
const std::string displaced = test::support("upper_far", "z", "-0.075");
std::string loaded(double pressure) {
  return fmt::format("[[loads]]\non = \"upper_far\"\npressure = {}\n", pressure);
}

Result press(const Case& tested, double size, bool measured_gap, const std::string& pressed = displaced) {
  const double R = tested.sphere ? 15 : 25, width = tested.sphere ? 0 : size;
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n[time]\nend = 1\n" + test::body("lower", 1, 0.3) +
                     test::body("upper", tested.upper_modulus, 0.3);
  for (const std::string body : {"lower", "upper"})
    toml += test::support(body + "_x0", "x") + test::support(body + "_y0", "y") +
            (tested.sphere ? "" : test::support(body + "_back", "y"));
  toml += test::support("lower_far", "z") + pressed;
  const std::string exact_gap = fmt::format("{0} - sqrt({0}^2 - min({0}^2, x*x{1}))", R, tested.sphere ? " + y*y" : "");
  toml += test::contact_table(
              "upper_round", "lower_top",
              fmt::format("slave = \"{}\"\ngap = \"{}\"", tested.slave, measured_gap ? "geometric" : exact_gap)) +
          test::probe("force", "contact_force_z", "on = \"upper_round\"") +
          test::probe("opposite", "contact_force_z", "on = \"lower_top\"") +
          test::probe("reaction", "reaction_z", "on = \"lower_far\"") +
          test::probe("area", "contact_area", "on = \"lower_top\"");
  const test::ContactState state =
      test::contact_state(toml, test::round_on_block_geo({tested.sphere, R, 1.5, size, width}));
  const double force = state.probes.at("force"), area = state.probes.at("area");
  EXPECT_RELATIVE(state.probes.at("opposite"), -force, 1e-13);
  EXPECT_RELATIVE(state.probes.at("reaction"), force, 1e-9);
  const double modulus = reference::contact_modulus({1, 0.3}, {tested.upper_modulus, 0.3});
  const reference::Hertz exact = tested.sphere ? reference::hertz_sphere(4 * force, R, modulus)
                                               : reference::hertz_cylinder(2 * force / width, R, modulus);
  return {test::hertz_errors(state.pairs.begin()->second, exact,
                             tested.sphere ? std::sqrt(4 * area / std::numbers::pi) : area / width,
                             [&](const Vector3& x) { return tested.sphere ? x.head<2>().norm() : x.x(); }),
          tested.sphere ? force : force / width};
}

class HertzRound : public testing::TestWithParam<Case> {};

TEST_P(HertzRound, MeasuredAndGivenGapsGiveTheHertzPressure) {
  const Case& tested = GetParam();
  const double fine_size = tested.sphere ? 0.17 : 0.1;
  const Result fine = press(tested, fine_size, true), coarse = press(tested, 1.8 * fine_size, true);
  test::expect_hertz(fine.errors, tested.sphere ? 0.02 : 0.01, "measured gap");
  EXPECT_LT(fine.errors.rms, 0.7 * coarse.errors.rms);
  if (!tested.also_given_gap) return;
  const Result given = press(tested, fine_size, false);
  test::expect_hertz(given.errors, tested.sphere ? 0.02 : 0.01, "given gap");
  EXPECT_RELATIVE(given.force, fine.force, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Cases, HertzRound,
                         testing::Values(Case{false, 1, "upper_round", true}, Case{false, 1, "lower_top", true},
                                         Case{false, 1e3, "auto", false}, Case{false, 1e-3, "auto", true},
                                         Case{true, 1, "upper_round", true}, Case{true, 1e3, "auto", false}),
                         [](const auto& parameter) {
                           const Case& tested = parameter.param;
                           return test::hertz_name(tested.sphere, tested.upper_modulus, tested.slave);
                         });

// Bodies that contact alone holds in the direction of the load.
TEST(HertzForceControl, ResultantIsTheLoad) {
  const Result cylinder = press({false, 1, "auto", false}, 0.1, true, loaded(3e-4));
  test::expect_hertz(cylinder.errors, 0.01, "cylinder");
  EXPECT_RELATIVE(cylinder.force, 3e-4 * 25, 1e-9);
  const Result sphere = press({true, 1, "auto", false}, 0.17, true, loaded(8e-5));
  test::expect_hertz(sphere.errors, 0.02, "sphere");
  const double quarter_top = std::numbers::pi / 4 * 15 * 15;
  EXPECT_RELATIVE(sphere.force, 8e-5 * quarter_top, 1e-3) << "the top is a circle of the mesh";
}

}  // namespace
}  // namespace hertz_round_tests
}  // namespace creepcontact
