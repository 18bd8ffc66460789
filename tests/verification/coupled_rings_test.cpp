/// Two rings whose joint conducts by its pressure and gap, heated outwards and inwards, over a hundred thousand hours,
/// against an integration along the radius by other means.

#include "verification/reference/coupled_rings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace coupled_rings_tests {
namespace {

using namespace test;
using reference::CoupledRings;
using reference::CoupledRingsHistory;

/// mm, N, h; heat in mJ and s. Films and fluids rise within 4 h.
CoupledRings rings(double fluid_at_bore, double fluid_at_rim) {
  return {.bore = 30,
          .fit = 60,
          .rim = 120,
          .interference = 0.055,
          .assembly_temperature = 20,
          .young_modulus = 1.75e5,
          .poisson_ratio = 0.3,
          .expansion = 1.2e-5,
          .A = 1e-16,
          .n = 5,
          .A_growth = 0.015,
          .A_temperature = 500,
          .conductivity = 35,
          .capacity = 7.8e-9 * 5.5e8,
          .time_unit = 3600,
          .ramp = 4,
          .at_bore = {{0, 5}, {20, fluid_at_bore}},
          .at_rim = {{0, 5}, {20, fluid_at_rim}},
          .joint = {.gas = 0.2, .gas_gap = 5e-3, .solid = 3, .solid_pressure = 50, .linear_below = 1e-7 * 1.75e5}};
}

std::string film(const std::string& on, const reference::RampedFilm& of, double time) {
  const auto ramp = [&](const reference::Ramp& value) {
    return fmt::format("{{ t = [0, {}], values = [{}, {}] }}", time, value.start, value.end);
  };
  return fmt::format("{{ on = \"{}\", coefficient = {}, fluid = {} }}", on, ramp(of.coefficient), ramp(of.fluid));
}

/// A sector of 10 degrees whose meshes do not match, up to the last of the times.
Outcome run(const CoupledRings& of, const std::vector<double>& times, double tolerance) {
  std::string toml = section_of("plane_stress");
  for (const std::string name : {"inner", "outer"})
    toml += fmt::format("[bodies.{0}]\nregion = \"{0}\"\nmaterial = \"steel\"\n", name) + support(name + "_y0", "y") +
            support(name + "_y1", "normal");
  toml += fmt::format(
      "[materials.steel]\nyoung_modulus = {}\npoisson_ratio = {}\nthermal_expansion = {}\nreference_temperature = {}\n"
      "conductivity = {}\nheat_capacity = {}\ndensity = 1\n"
      "[[materials.steel.creep]]\nlaw = \"norton\"\nA = \"{}*exp({}*(T - {}))\"\nn = {}\n",
      of.young_modulus, of.poisson_ratio, of.expansion, of.assembly_temperature, of.conductivity, of.capacity, of.A,
      of.A_growth, of.A_temperature, of.n);
  toml += fmt::format("[heat]\nstart = {}\ntime_unit = {}\nfilms = [{}, {}]\n", of.assembly_temperature, of.time_unit,
                      film("inner_x0", of.at_bore, of.ramp), film("outer_x1", of.at_rim, of.ramp));
  toml += contact_table("inner_x1", "outer_x0",
                        fmt::format("gap = {}\nconductance = \"{}/(1 + gap/{}) + {}*(p/{})^0.95\"", -of.interference,
                                    of.joint.gas, of.joint.gas_gap, of.joint.solid, of.joint.solid_pressure));
  toml +=
      fmt::format("[time]\nend = {}\noutput = [{}]\ntolerance = {}\n", times.back(), fmt::join(times, ", "), tolerance);
  toml += probe("p", "contact_pressure", "on = \"inner_x1\"") + probe("gap", "gap", "on = \"inner_x1\"") +
          probe("bore", "temperature", "on = \"inner_x0\"") + probe("inner_face", "temperature", "on = \"inner_x1\"") +
          probe("outer_face", "temperature", "on = \"outer_x0\"") + probe("rim", "temperature", "on = \"outer_x1\"");
  const double angle = std::numbers::pi / 18;
  return run_case(toml, regions_geo({{"inner", {of.bore, of.fit, 6, 1.05}, {0, angle, 2}, true},
                                     {"outer", {of.fit, of.rim, 7, 1.15}, {0, angle, 3}, true}}));
}

/// Pressures within the tolerance times that of the start, temperatures and gaps within what makes a stress of twice
/// the largest one.
void expect_agreement(const CoupledRings& of, const std::vector<double>& times) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const Table history = run(of, times, tolerance).history;
    CoupledRingsHistory reference(of);
    const double pressure = tolerance * reference.at(0).pressure;
    const double degrees = 200 * tolerance, length = of.expansion * of.fit * degrees;
    for (const double t : times) {
      const auto exact = reference.at(t);
      EXPECT_NEAR(history.at("p", t), exact.pressure, pressure) << t;
      EXPECT_NEAR(history.at("gap", t), exact.gap, length) << t;
      EXPECT_NEAR(history.at("bore", t), exact.bore, degrees) << t;
      EXPECT_NEAR(history.at("inner_face", t), exact.inner_face, degrees) << t;
      EXPECT_NEAR(history.at("outer_face", t), exact.outer_face, degrees) << t;
      EXPECT_NEAR(history.at("rim", t), exact.rim, degrees) << t;
    }
  }
}

/// The time to 1 h at which the contact is lost, between two times.
double lost(const CoupledRings& of, int after, int before) {
  CoupledRingsHistory reference(of);
  for (int t = after; t < before; ++t)
    if (reference.at(t).pressure == 0) return t;
  ADD_FAILURE() << "it is not";
  return before;
}

/// From 48 MPa up to 76 in the start, down to 13.
TEST(CoupledRings, HeatedOutwardsRelax) {
  expect_agreement(rings(550, 450), {0, 0.5, 1, 2, 4, 6, 24, 100, 1e3, 1e4, 1e5});
}

/// The pressure falls to 5.3 MPa in 13110 h; then the joint opens within an hour, by 15 um.
TEST(CoupledRings, HeatedInwardsLoseTheirContact) {
  const CoupledRings of = rings(450, 550);
  expect_agreement(of, {0, 0.5, 1, 2, 4, 6, 24, 100, 1e3, 1e4, 1.4e4, 1e5});
  const double time = lost(of, 13000, 14000);
  for (const auto& [tolerance, error] : {std::pair{1e-3, 50.0}, {1e-4, 6.0}}) {
    const Table history = run(of, {time - error, time + error}, tolerance).history;
    EXPECT_GT(history.at("p", time - error), 5) << tolerance;
    EXPECT_EQ(history.at("p", time + error), 0) << tolerance;
    EXPECT_GT(history.at("gap", time + error), 0.01) << tolerance;
  }
}

/// The rim is heated within half an hour, the bore hardly: the joint opens by 0.12 mm, and closes as the heat comes
/// through.
TEST(CoupledRings, OpenInAFastStartAndClose) {
  CoupledRings of = rings(500, 550);
  of.ramp = 0.5;
  of.at_bore.coefficient.end = 0.1;
  expect_agreement(of, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 4, 24, 100, 1e3, 1e4, 1e5});
}

}  // namespace
}  // namespace coupled_rings_tests
}  // namespace creepcontact
