/// Hertz contact: contact radius, pressure and resultant of spheres and cylinders on a half space.

#include "verification/contact_state.hpp"
#include "verification/half_space.hpp"
#include "verification/reference/hertz.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace {

using test::HalfSpace;

constexpr double curvature = 10;

struct Measured {
  double radius;    // from a straight line through p^2 over r^2
  double pressure;  // the largest
  double rms;       // of the error of the pressure over the contact, relative to the largest
  double area_radius, force, unbalance;
};

struct Case {
  std::string name;
  bool sphere;
  double lower_modulus, upper_modulus;
  std::string slave;
};

Measured compare(const Case& tested, int fine, reference::Hertz& exact) {
  // contact radius near 1
  const double width = tested.sphere ? 0 : 1.5 / fine;
  const double extent = tested.sphere ? 15 : 30;
  const HalfSpace lower{"lower", 0, -1, 1.5, fine, extent, tested.sphere ? 5 : 10, tested.sphere ? 7 : 12, width};
  const HalfSpace upper{"upper", 0, 1, 1.5, fine * 3 / 4, extent, tested.sphere ? 5 : 10, tested.sphere ? 7 : 12, width};
  const double E = 1 / (1 / tested.lower_modulus + 1 / tested.upper_modulus);
  const std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("lower", tested.lower_modulus, 0.3) +
      test::body("upper", tested.upper_modulus, 0.3) + test::half_space_supports(lower, 0) +
      test::half_space_supports(upper, tested.sphere ? -0.11 : -0.25) +
      fmt::format("[[contacts]]\nname = \"contact\"\nbetween = [\"lower_patch\", \"upper_patch\"]\nslave = \"{}\"\n"
                  "gap = \"(x*x{})/{}\"\n[time]\nend = 1\n",
                  tested.slave, tested.sphere ? " + y*y" : "", 2 * curvature) +
      test::probe("force", "contact_force_z", "on = \"upper_patch\"") +
      test::probe("opposite", "contact_force_z", "on = \"lower_patch\"") +
      test::probe("reaction", "reaction_z", "on = \"upper_far\"") +
      test::probe("area", "contact_area", "on = \"upper_patch\"");
  const test::ContactState state = test::contact_state(
      toml, "SetFactory(\"OpenCASCADE\");\n" + test::half_space_geo(lower) + test::half_space_geo(upper));
  const reference::Elastic a{tested.lower_modulus, 0.3}, b{tested.upper_modulus, 0.3};
  const double modulus = reference::contact_modulus(a, b);
  const double force = state.probes.at("force");
  exact = tested.sphere ? reference::hertz_sphere(4 * force, curvature, modulus)
                        : reference::hertz_cylinder(2 * force / width, curvature, modulus);
  Measured m{};
  m.force = force;
  m.unbalance = std::max(std::abs(state.probes.at("opposite") + force), std::abs(state.probes.at("reaction") + force)) / force;
  m.area_radius = tested.sphere ? std::sqrt(4 * state.probes.at("area") / M_PI) : state.probes.at("area") / width;
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, sum = 0, weight = 0;
  for (const auto& p : state.pairs.at("contact")) {
    const double r = tested.sphere ? p.place.head<2>().norm() : p.place.x();
    m.pressure = std::max(m.pressure, p.pressure);
    const double error = p.pressure - exact(r);
    if (r < exact.radius || p.pressure > 0) {
      sum += p.area * error * error;
      weight += p.area;
    }
    if (getenv("PROFILE")) std::printf("   %8.4f %10.5f %10.5f  %9.2e %d\n", r / exact.radius, p.pressure / exact.pressure, exact(r) / exact.pressure, p.gap, p.pressure > 0);
    const double x = r * r / (exact.radius * exact.radius), y = p.pressure * p.pressure;
    if (x < 0.25 || x > 0.9) continue;
    n += 1;
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx), at0 = (sy - slope * sx) / n;
  m.radius = std::sqrt(-at0 / slope) * exact.radius;
  m.rms = std::sqrt(sum / weight) / exact.pressure;
  std::printf("%s %s fine %d: E %g a %.4f p0 %.5g | radius %+.3f%% area radius %+.3f%% peak %+.3f%% rms %.3f%% unbalance %.1e\n",
              tested.name.c_str(), state.slave.at("contact").c_str(), fine, E, exact.radius, exact.pressure, 100 * (m.radius / exact.radius - 1),
              100 * (m.area_radius / exact.radius - 1), 100 * (m.pressure / exact.pressure - 1), 100 * m.rms,
              m.unbalance);
  return m;
}

TEST(Hertz, Explore) {
  for (const bool sphere : {false, true})
    for (const double ratio : {1.0, 1e3, 1e-3})
      for (const char* slave : {"auto", "lower_patch", "upper_patch"})
        for (const int fine : {8, 16}) {
          if (sphere && fine == 16 && !getenv("FINE")) continue;
          reference::Hertz exact{};
          compare({sphere ? "sphere" : "cylinder", sphere, 1, ratio, slave}, fine, exact);
        }
}

}  // namespace
}  // namespace creepcontact
