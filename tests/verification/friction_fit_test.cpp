/// Press fits: the force that pushes them out and the torque that they transmit.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/reference/ring_fit.hpp"
#include "verification/reference/thick_cylinder.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_fit_cases {
namespace {

constexpr double inner = 0.5, radius = 1, outer = 2, length = 1, modulus = 2e5, interference = 0.002, friction = 0.15;

/// The ends of shaft and hub keep their lengths (plane strain). After `rest` the hub is pushed along the shaft by a
/// displacement of 0.01 in a time of 1.
test::Table push_out(double rest, double A, double n) {
  const std::string pushed = rest > 0 ? fmt::format("{{ t = [0, {0}, {1}], values = [0, 0, 0.01] }}", rest, rest + 1)
                                      : "{ t = [0, 1], values = [0, 0.01] }";
  return test::run_case(test::section_of("axisymmetric") + test::body("shaft", modulus, 0.3, A, n) +
                            test::body("hub", modulus, 0.3, A, n) + test::support("shaft_y0", "y") +
                            test::support("shaft_y1", "y") + test::support("hub_y0", "y", pushed) +
                            test::support("hub_y1", "y", pushed) +
                            test::contact_table("shaft_x1", "hub_x0",
                                                fmt::format("friction = {}\ngap = {}", friction, -interference)) +
                            fmt::format("[time]\nend = {}\ntolerance = 1e-5\noutput = [{}{}, {}]\n", rest + 1,
                                        rest > 0 ? fmt::format("{}, ", rest) : "", rest + 0.25, rest + 0.5) +
                            test::probe("pressure", "contact_pressure", "on = \"shaft_x1\"") +
                            test::probe("force", "contact_force_y", "on = \"hub_x0\"") +
                            test::probe("status", "contact_status", "on = \"hub_x0\"\nreduce = \"min\""),
                        test::regions_geo({{"shaft", {inner, radius, 4}, {0, length, 8}},
                                           {"hub", {radius, outer, 6}, {0, length, 11}}}))
      .history;
}

reference::RingFit exact(double A = 0, double n = 1) {
  return {
      {inner, radius, modulus, 0.3, A, n}, {radius, outer, modulus, 0.3, A, n}, interference, reference::Plane::strain};
}

TEST(PressFit, PushOutForce) {
  const test::Table history = push_out(0, 0, 1);
  const double force = friction * exact().elastic_pressure() * 2 * std::numbers::pi * radius * length;
  EXPECT_NEAR(history.at("force", 0), 0, 1e-9 * force);
  for (const double t : {0.25, 0.5, 1.0}) {
    EXPECT_EQ(history.at("status", t), 2) << t;
    EXPECT_RELATIVE(-history.at("force", t), force, 1e-4);
  }
}

TEST(PressFit, PushOutForceAfterRelaxation) {
  constexpr double A = 1e-16, n = 5, rest = 1000;
  const test::Table history = push_out(rest, A, n);
  const double pressure = exact(A, n).pressure({rest})[0];
  EXPECT_LT(pressure, 0.4 * exact().elastic_pressure());
  EXPECT_RELATIVE(history.at("pressure", rest), pressure, 1e-3);
  EXPECT_NEAR(history.at("force", rest), 0, 1e-6 * pressure);
  EXPECT_EQ(history.at("status", rest + 0.25), 2);
  EXPECT_RELATIVE(-history.at("force", rest + 0.25),
                  friction * 2 * std::numbers::pi * radius * length * history.at("pressure", rest + 0.25), 1e-8);
  EXPECT_RELATIVE(history.at("pressure", rest + 0.25), pressure, 1e-3);
}

/// Pressure of the fit of a shaft whose bore is held, plane strain.
double pressure_on_held_bore() {
  constexpr double nu = 0.3, shear = modulus / (2 * (1 + nu)), lame = 2 * shear * nu / (1 - 2 * nu);
  constexpr double a = inner * inner;
  const double shaft = (radius - a / radius) / (2 * lame + 2 * shear * (1 + a / (radius * radius)));
  return interference / (shaft + reference::ThickCylinder{radius, outer, 1}.elastic_displacement(radius, modulus, nu));
}

/// Nothing but the fit holds the hub against turning and shifting. @param part  of the torque it can transmit
std::string twisted(double part) {
  constexpr double thickness = 0.4;
  const double torque = part * friction * pressure_on_held_bore() * 2 * std::numbers::pi * radius * radius * thickness;
  const double traction = torque / (2 * std::numbers::pi * outer * outer * outer * thickness);  // per radius
  return "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("shaft", modulus, 0.3) +
         test::body("hub", modulus, 0.3) + test::support("shaft_ends", "z") + test::support("hub_ends", "z") +
         test::support("shaft_inner", "x") + test::support("shaft_inner", "y") +
         test::contact_table("shaft_outer", "hub_inner",
                             fmt::format("friction = {}\ngap = {}", friction, -interference)) +
         fmt::format("[[loads]]\non = \"hub_outer\"\ntraction = [\"-{0}*y*t\", \"{0}*x*t\", 0]\n", traction) +
         "[time]\nend = 1\noutput = [0.5, 0.9, 0.95]\n" +
         test::probe("pressure", "contact_pressure", "on = \"hub_inner\"") +
         test::probe("shear", "contact_shear", "on = \"hub_inner\"") +
         test::probe("torque", "contact_moment_z", "on = \"hub_inner\"");
}

TEST(PressFit, TorqueThatItTransmits) {
  const std::string geo = test::full_rings_geo({{"shaft", inner, radius, 16}, {"hub", radius, outer, 24}}, 0.4, 0.4);
  const double pressure = pressure_on_held_bore();
  const double limit = friction * pressure * 2 * std::numbers::pi * radius * radius * 0.4;
  const test::Table history = test::run_case(twisted(0.99), geo).history;
  EXPECT_RELATIVE(history.at("pressure", 0), pressure, 3e-3);
  for (const double t : {0.5, 0.95, 1.0}) EXPECT_RELATIVE(-history.at("torque", t), 0.99 * t * limit, 1e-3) << t;
  EXPECT_RELATIVE(history.at("shear", 1), 0.99 * friction * pressure, 3e-3);
  const test::Outcome failed = test::run_to_failure(twisted(1.01), geo);
  EXPECT_EQ(failed.exit_status, 3);
  EXPECT_EQ(failed.history.times().back(), 0.95);
  EXPECT_TRUE(test::says(failed.message, {"body 'hub'", "rotation"}));
}

}  // namespace
}  // namespace friction_fit_cases
}  // namespace creepcontact
