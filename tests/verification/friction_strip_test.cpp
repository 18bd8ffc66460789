/// A strip pressed on a stiff foundation and pulled at its end: slip that spreads from the end inwards.

#include <fmt/format.h>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/reference/friction.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_strip_cases {
namespace {

constexpr double length = 2, thickness = 0.05, pressure = 1, friction = 0.3;

/// @param end_stress  TOML, tension of the strip's end
/// @param strip  its body. @param time  [time]
/// @param base  elements along the foundation; the strip has 64
test::Outcome pull(const std::string& strip, const std::string& end_stress, const std::string& time, int base = 50) {
  return test::run_case(
      test::section_of("plane_strain") + test::body("base", 1e6, 0.3) + strip + test::support("base_y0", "y") +
          test::support("base_y0", "x") + test::support("strip_x0", "x") +
          test::contact_table("strip_y0", "base_y1", fmt::format("friction = {}", friction)) +
          fmt::format("[[loads]]\non = \"strip_y1\"\npressure = {}\n[[loads]]\non = \"strip_x1\"\ntraction = [{}, 0, "
                      "0]\n",
                      pressure, end_stress) +
          time + test::probe("end", "displacement_x", "on = \"strip_x1\"") +
          test::probe("slip", "slip", "on = \"strip_y0\"\nreduce = \"max\"") +
          test::probe("held", "contact_force_x", "on = \"strip_y0\""),
      test::regions_geo({{"base", {0, length, base}, {-0.3, 0, 2}}, {"strip", {0, length, 64}, {0, thickness, 2}}}));
}

std::string path(int steps_per_unit) {
  std::string times;
  for (int k = 1; k <= 5 * steps_per_unit; ++k)
    times += fmt::format("{}{:.12f}", k > 1 ? ", " : "", static_cast<double>(k) / steps_per_unit);
  return "[time]\nend = 5\noutput = [" + times + "]\n";
}

/// The force slips over 0.7 of the length, then turns to its opposite and back.
TEST(FrictionStrip, HysteresisOfTheEnd) {
  constexpr double modulus = 1000, force = 0.7 * length * friction * pressure;
  const reference::PulledStrip exact{modulus, thickness, friction, pressure};
  const std::string stress = fmt::format("{{ t = [0, 1, 3, 5], values = [0, {0}, -{0}, {0}] }}", force / thickness);
  // Without lateral contraction, as in the bar.
  const auto run = [&](int steps) { return pull(test::body("strip", modulus, 0), stress, path(steps)); };
  const test::Outcome outcome = run(16);
  const test::Table& history = outcome.history;
  const double u = exact.displacement(force);
  for (const double t : {0.5, 0.75, 1.0})
    EXPECT_NEAR(history.at("end", t) / u, exact.displacement(t * force) / u, 0.012) << t;
  for (const double t : {1.5, 2.0, 3.0})
    EXPECT_NEAR(history.at("end", t) / u, exact.unloading((2 - t) * force, force) / u, 0.015) << t;
  for (const double t : {3.5, 4.0, 5.0})
    EXPECT_NEAR(history.at("end", t) / u, -exact.unloading((4 - t) * force, force) / u, 0.015) << t;
  EXPECT_NEAR(history.at("end", 5), history.at("end", 1), 1e-6 * u) << "the loop closes";
  const std::string dissipated = "contacts/strip_y0~1base_y1/dissipated_energy";
  EXPECT_RELATIVE(outcome.summary.number(dissipated), 1.25 * exact.loop_energy(force), 0.004);

  // In a monotonic part the states do not depend on the steps.
  const test::Outcome in_few_steps = run(1);
  for (const double t : {1.0, 3.0, 5.0})
    EXPECT_NEAR(in_few_steps.history.at("end", t), history.at("end", t), 1e-6 * u) << t;
  EXPECT_RELATIVE(in_few_steps.summary.number(dissipated), outcome.summary.number(dissipated), 1e-3);
}

/// The end moves with a constant velocity, as the stresses do not change.
TEST(FrictionStrip, CreepsAtAConstantVelocity) {
  constexpr double A = 1e-6, n = 3, stress = 4, end = 40;
  const reference::PulledStrip exact{1000, thickness, friction, pressure};
  const test::Table history =
      pull(test::body("strip", 1000, 0.49, A, n), fmt::format("{}", stress),
           fmt::format("[time]\nend = {}\noutput = {{ first = 5, count = 8, spacing = \"linear\" }}\n", end))
          .history;
  const double velocity = exact.creep_velocity(stress * thickness, A, n);
  for (int step = 0; step < 8; ++step)
    EXPECT_RELATIVE((history.at("end", 5 * (step + 1)) - history.at("end", 5 * step)) / 5, velocity, 0.025) << step;
}

/// On the same mesh; reference/calculix_strip.py makes the deck and prints these values. CalculiX 2.20, whose friction
/// is regularized by a stiffness.
TEST(FrictionStrip, AgreesWithCalculix) {
  constexpr double force = 0.7 * length * friction * pressure;
  const test::Table history = pull(test::body("strip", 1000, 0), fmt::format("\"{}*t\"", force / thickness),
                                   "[time]\nend = 1\noutput = [0.25, 0.5, 0.75, 1]\n", 64)
                                  .history;
  EXPECT_RELATIVE(history.at("end", 0.25), 3.575087e-4, 5e-4);
  EXPECT_RELATIVE(history.at("end", 0.5), 1.444176e-3, 5e-4);
  EXPECT_RELATIVE(history.at("end", 0.75), 3.265962e-3, 5e-4);
  EXPECT_RELATIVE(history.at("end", 1), 5.822693e-3, 5e-4);
}

}  // namespace
}  // namespace friction_strip_cases
}  // namespace creepcontact
