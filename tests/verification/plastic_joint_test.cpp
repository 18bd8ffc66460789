/// A bolt that yields when it is tightened and then relaxes, in series with an elastic joint: stiffness of both 750.
///   eps_p = (d K - sy)/(K + H), sigma_0 = (d - eps_p) K, sigma = (sigma_0^(1-n) + (n-1) A K t)^(1/(1-n))

#include <fmt/format.h>

#include <cmath>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_joint_tests {
namespace {

using namespace test;

constexpr double d = 4e-3, K = 750, A = 1e-4, n = 5;
const std::vector<double> times{1, 10, 100, 1000};
const std::string creep = "[[materials.bolt.creep]]\nlaw = \"norton\"\nA = 1e-4\nn = 5\n";

double flow(double H) {
  return (d * K - 1) / (K + H);
}

double stress(double H, double t) {
  const double start = (d - flow(H)) * K;
  return std::pow(std::pow(start, 1 - n) + (n - 1) * A * K * t, 1 / (1 - n));
}

/// Two blocks of height 1 that press each other; the joint has three times the modulus of the bolt.
/// @param squeeze  displacement of the upper end
Table press(const std::string& plasticity, const std::string& squeeze, const std::string& contact,
            const std::string& time) {
  std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("bolt", 1000, 0.3) + "plasticity = " + plasticity + "\n" +
      creep + body("joint", 3000, 0.3) + contact_table("bolt_z1", "joint_z0", contact) + "[time]\ntolerance = 1e-5\n" +
      time + "\n" + support("bolt_z0", "z") + support("joint_z1", "z", squeeze) +
      probe("stress", "stress_zz", "body = \"bolt\"") + probe("pressure", "contact_pressure", "on = \"bolt_z1\"") +
      probe("flow", "plastic_strain_zz", "body = \"bolt\"");
  for (const char* name : {"bolt", "joint"})
    toml += support(name + std::string("_x0"), "x") + support(name + std::string("_y0"), "y");
  return run_case(toml,
                  boxes_geo({{"bolt", {0, 0, 0}, {1, 1, 1}, {1, 1, 2}}, {"joint", {0, 0, 1}, {1, 1, 1}, {2, 2, 2}}}))
      .history;
}

std::string hardening(double H) {
  return fmt::format("{{ yield_stress = 1, hardening_modulus = {:.15g} }}", H);
}

class PlasticBolt : public testing::TestWithParam<double> {};

TEST_P(PlasticBolt, TightenedAtOnceRelaxesByTheClosedForm) {
  const double H = GetParam();
  const Table history = press(hardening(H), "-4e-3", "", "end = 1000\noutput = [1, 10, 100]");
  EXPECT_NEAR(history.at("stress", 0), -stress(H, 0), 1e-6);
  EXPECT_NEAR(history.at("flow", 0), -flow(H), 1e-8);
  for (const double t : times) {
    EXPECT_NEAR(history.at("stress", t), -stress(H, t), 2e-5) << t;
    EXPECT_NEAR(history.at("pressure", t), stress(H, t), 2e-5) << t;
    EXPECT_NEAR(history.at("flow", t), -flow(H), 1e-8) << "what relaxes unloads elastically";
  }
}

/// By an overlap of the surfaces that grows in little time, and with kinematic hardening, which is the same one way.
TEST_P(PlasticBolt, TightenedByItsNutRelaxesByTheClosedForm) {
  const double H = GetParam();
  const Table history =
      press(fmt::format("{{ yield_stress = 1, kinematic = [{{ C = {:.15g}, gamma = 0 }}] }}", H), "0",
            "gap = { t = [0, 1e-6], values = [0, -4e-3] }", "end = 1000\noutput = [1e-6, 1, 10, 100]");
  EXPECT_NEAR(history.at("pressure", 1e-6), stress(H, 0), 1e-5);
  for (const double t : times) EXPECT_NEAR(history.at("pressure", t), stress(H, t), 3e-5) << t;
  EXPECT_NEAR(history.at("flow", 1000), -flow(H), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Hardening, PlasticBolt, testing::Values(0.0, 1000.0 / 99, 400.0));

/// Relaxed, and tightened by half as much again: it yields where the first tightening has left the yield stress.
TEST(RetightenedBolt, YieldsAgainAtTheHardenedStress) {
  const double H = 50;
  const Table history = press(hardening(H), "-4e-3", "gap = { t = [0, 100, 100.0001], values = [0, 0, -2e-3] }",
                              "end = 200\noutput = [99.9999, 100.0001]");
  const double relaxed = stress(H, 100), yield = stress(H, 0);
  // From the relaxed stress elastically to the yield stress of then, and on.
  const double more = (2e-3 * K - (yield - relaxed)) / (K + H);
  const double top = yield + H * more;
  EXPECT_NEAR(history.at("flow", 100.0001), -(flow(H) + more), 2e-7);
  EXPECT_NEAR(history.at("pressure", 100.0001), top, 1e-4);
  EXPECT_NEAR(history.at("pressure", 200), std::pow(std::pow(top, 1 - n) + (n - 1) * A * K * 100, 1 / (1 - n)), 1e-4);
}

}  // namespace
}  // namespace plastic_joint_tests
}  // namespace creepcontact
