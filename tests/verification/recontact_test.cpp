/// Contact that opens and closes again in the course of creep, under a load that comes and goes.
#include <algorithm>
#include <cmath>

#include "boxes.hpp"
#include "case.hpp"
#include "rings.hpp"

namespace creepcontact::test {
namespace {

/// Two blocks, the upper one moved by -0.02 cos(pi t/250): pressed, pulled off, pressed again ...
/// While they touch, c dp/dt = -dU/dt - (A1 L1 + A2 L2) p^n with c = L1/E1 + L2/E2; the reference by small steps.
double pressure_by_small_steps(double end) {
  constexpr double c = 2.0 / 1e5 + 2.0 / 1e5, rate = 2.0 * 1e-12, n = 4;
  constexpr int steps = 400000;
  const double h = end / steps;
  double creep = 0, pressure = 0;  // shortening of the creeping block
  for (int i = 0; i <= steps; ++i) {
    const double pressed = 4e-3 * std::cos(std::acos(-1.0) * i * h / 250);
    pressure = std::max(0.0, (pressed - creep) / c);
    creep += h * rate * std::pow(pressure, n);
  }
  return pressure;
}

TEST(Recontact, IsNotPassedOverByAnyIntegrator) {
  const std::string geo =
      boxes_geo({{"lower", {0, 0, 0}, {1, 1, 2}, {2, 2, 2}}, {"upper", {0, 0, 2}, {1, 1, 2}, {3, 3, 2}}});
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 1\n" + body("lower", 1e5, 0.3, 1e-12, 4) +
                     body("upper", 1e5, 0.3) + support("lower_z0", "z") +
                     support("upper_z1", "z", "\"-4e-3*cos(pi*t/250)\"") + contact_table("lower_z1", "upper_z0") +
                     "[time]\nend = 1000\noutput = [500, 1000]\n" + probe("p", "contact_pressure", "on = \"lower_z1\"");
  for (const char* name : {"lower", "upper"}) {
    toml += support(std::string(name) + "_x0", "x");
    toml += support(std::string(name) + "_y0", "y");
  }
  for (const char* integrator : {"cvode_bdf", "cvode_adams", "log_adams", "arkode_erk", "arkode_dirk"}) {
    SCOPED_TRACE(integrator);
    const Table history = run_case(toml, geo, {std::string("time.integrator=") + integrator}).history;
    for (const double t : {500.0, 1000.0}) EXPECT_RELATIVE(history.at("p", t), pressure_by_small_steps(t), 3e-3);
  }
}

}  // namespace
}  // namespace creepcontact::test
