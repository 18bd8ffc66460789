/// Cylinders and spheres pressed and then sheared: the shear traction of Cattaneo and Mindlin.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/half_space.hpp"
#include "verification/hertz_profile.hpp"
#include "verification/plane_regions.hpp"
#include "verification/reference/friction.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace friction_hertz_cases {
namespace {

constexpr double friction = 0.3, curvature = 10, poisson_ratio = 0.3, patch = 1.5, extent = 30;

/// A half plane on both sides of x = 0, with `fine` elements on each half of the patch. Groups as of half_plane_geo().
std::string whole_half_plane(const std::string& name, double direction, int fine) {
  constexpr int coarse = 12, deep = 16;
  const double h = patch / fine;
  return fmt::format(R"(
    p = newp; l = newl; k = newll; s = news; X[] = {{-{1}, -{0}, {0}, {1}}};
    For i In {{0:3}}
      Point(p + i) = {{X[i], 0, 0}}; Point(p + 4 + i) = {{X[i], {2}, 0}}; Line(l + 6 + i) = {{p + i, p + 4 + i}};
    EndFor
    Line(l) = {{p + 1, p}}; Line(l + 1) = {{p + 1, p + 2}}; Line(l + 2) = {{p + 2, p + 3}};
    Line(l + 3) = {{p + 5, p + 4}}; Line(l + 4) = {{p + 5, p + 6}}; Line(l + 5) = {{p + 6, p + 7}};
    Transfinite Curve{{l, l + 2, l + 3, l + 5}} = {3} + 1 Using Progression {5:.12g};
    Transfinite Curve{{l + 1, l + 4}} = 2*{7} + 1; Transfinite Curve{{l + 6:l + 9}} = {4} + 1 Using Progression {6:.12g};
    Curve Loop(k) = {{-l, l + 7, l + 3, -(l + 6)}}; Curve Loop(k + 1) = {{l + 1, l + 8, -(l + 4), -(l + 7)}};
    Curve Loop(k + 2) = {{l + 2, l + 9, -(l + 5), -(l + 8)}};
    For i In {{0:2}}
      Plane Surface(s + i) = {{k + i}}; Transfinite Surface{{s + i}}; Recombine Surface{{s + i}};
    EndFor
    Physical Surface("{8}") = {{s:s + 2}}; Physical Curve("{8}_patch") = {{l + 1}};
    Physical Curve("{8}_far") = {{l + 3:l + 5}};
  )",
                     patch, extent, direction * extent, coarse, deep, test::growth(h, extent - patch, coarse),
                     test::growth(h, extent, deep), fine, name);
}

struct Sheared {
  double ratio;   ///< Q/(mu P)
  double rms;     ///< error of the shear traction over the contact, relative to mu times the largest pressure
  double centre;  ///< error of the traction in the middle, likewise
  double stick;   ///< area that sticks over the area in contact
};

constexpr double below_limit = 1 - 1e-6;

/// @param x_of  distance from the middle of the contact
template <class Distance>
Sheared compare(const std::vector<test::ContactPoint>& points, double Q_ratio, const reference::CattaneoMindlin& exact,
                const Distance& x_of) {
  const double unit = friction * exact.full.pressure;
  double sum = 0, area = 0, nearest = 1, centre = 0, touching = 0, sticking = 0;
  for (const test::ContactPoint& point : points) {
    touching += point.pressure > 0 ? point.area : 0;
    // The load grows in one direction: what slips is at the limit.
    sticking += point.shear.norm() < below_limit * friction * point.pressure ? point.area : 0;
    const double x = x_of(point.position);
    if (x > exact.full.radius) continue;
    const double error = (std::abs(point.shear.x()) - exact.shear(x)) / unit;
    const double across = point.shear.y() / unit;
    sum += point.area * (error * error + across * across);
    area += point.area;
    if (x < nearest) nearest = x, centre = error;
  }
  return {Q_ratio, std::sqrt(sum / area), centre, sticking / touching};
}

std::vector<double> times_before(int steps) {
  std::vector<double> times;
  for (int k = 0; k < steps; ++k) times.push_back(static_cast<double>(k) / steps);
  return times;
}

std::string contact_of(const std::string& slave, const std::string& gap) {
  return test::contact_table("lower_patch", "upper_patch",
                             fmt::format("slave = \"{}\"\nfriction = {}\ngap = \"{}\"", slave, friction, gap));
}

/// Pressed at t = 0, then moved along the surface in equal steps.
Sheared shear(int fine, int steps, double way, const std::string& slave) {
  const test::ContactState state = test::contact_state(
      test::section_of("plane_strain") + "[time]\nend = 1\n" + test::body("lower", 1, poisson_ratio) +
          test::body("upper", 1, poisson_ratio) + test::support("lower_far", "x") + test::support("lower_far", "y") +
          test::support("upper_far", "x", fmt::format("\"{}*t\"", way)) + test::support("upper_far", "y", "-0.25") +
          contact_of(slave, fmt::format("x*x/{}", 2 * curvature)) +
          test::probe("pressing", "contact_force_y", "on = \"upper_patch\"") +
          test::probe("shearing", "contact_force_x", "on = \"upper_patch\""),
      "SetFactory(\"OpenCASCADE\");\n" + whole_half_plane("lower", -1, fine) +
          whole_half_plane("upper", 1, fine * 3 / 4),
      {}, 1, times_before(steps));
  const double P = state.probes.at("pressing"), Q = std::abs(state.probes.at("shearing"));
  const double modulus = reference::contact_modulus({1, poisson_ratio}, {1, poisson_ratio});
  const reference::CattaneoMindlin exact{friction, reference::hertz_cylinder(P, curvature, modulus),
                                         reference::hertz_cylinder(P - Q / friction, curvature, modulus)};
  EXPECT_RELATIVE(exact.stick_radius() / exact.full.radius, std::sqrt(1 - Q / (friction * P)), 1e-12);
  return compare(state.pairs.begin()->second, Q / (friction * P), exact,
                 [](const Vector3& x) { return std::abs(x.x()); });
}

/// Halves of two spheres, on one side of the plane of the loads. The closed form takes all tractions along the load:
/// exact without lateral contraction.
Sheared shear_spheres(int fine, double poisson, double way, const std::string& slave) {
  constexpr int coarse = 5, deep = 7;
  constexpr double size = 15;
  const test::HalfSpace lower{"lower", 0, -1, patch, fine, size, coarse, deep, 0, true};
  const test::HalfSpace upper{"upper", 0, 1, patch, fine * 3 / 4, size, coarse, deep, 0, true};
  const test::ContactState state = test::contact_state(
      "[mesh]\nfile = \"case.geo\"\norder = 2\n[time]\nend = 1\n" + test::body("lower", 1, poisson) +
          test::body("upper", 1, poisson) + test::half_space_supports(lower, 0) +
          test::half_space_supports(upper, -0.11) + test::support("lower_far", "x") +
          test::support("upper_far", "x", fmt::format("\"{}*t\"", way)) +
          contact_of(slave, fmt::format("(x*x + y*y)/{}", 2 * curvature)) +
          test::probe("pressing", "contact_force_z", "on = \"upper_patch\"") +
          test::probe("shearing", "contact_force_x", "on = \"upper_patch\""),
      "SetFactory(\"OpenCASCADE\");\n" + test::half_space_geo(lower) + test::half_space_geo(upper), {}, 1,
      times_before(2));
  const double P = 2 * state.probes.at("pressing"), Q = 2 * std::abs(state.probes.at("shearing"));
  const double modulus = reference::contact_modulus({1, poisson}, {1, poisson});
  const reference::CattaneoMindlin exact{friction, reference::hertz_sphere(P, curvature, modulus),
                                         reference::hertz_sphere(P - Q / friction, curvature, modulus)};
  EXPECT_RELATIVE(exact.stick_radius() / exact.full.radius, std::cbrt(1 - Q / (friction * P)), 1e-12);
  return compare(state.pairs.begin()->second, Q / (friction * P), exact,
                 [](const Vector3& x) { return x.head<2>().norm(); });
}

class CattaneoMindlin : public testing::TestWithParam<const char*> {};

TEST_P(CattaneoMindlin, ShearTractionConverges) {
  for (const double way : {0.05, 0.1}) {
    const Sheared fine = shear(32, 2, way, GetParam()), coarse = shear(8, 2, way, GetParam());
    EXPECT_LT(fine.rms, 0.006) << way;
    EXPECT_LT(std::abs(fine.centre), 0.0025) << way;
    EXPECT_LT(fine.rms, 0.4 * coarse.rms) << way;
  }
}

// The load grows in proportion: one backward step is exact.
TEST_P(CattaneoMindlin, DoesNotDependOnTheSteps) {
  const Sheared one = shear(16, 1, 0.1, GetParam()), many = shear(16, 8, 0.1, GetParam());
  EXPECT_NEAR(one.ratio, many.ratio, 1e-8);
  EXPECT_NEAR(one.rms, many.rms, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Slaves, CattaneoMindlin, testing::Values("lower_patch", "upper_patch"),
                         [](const auto& of) { return std::string(of.param); });

struct Spheres {
  const char* slave;
  double poisson, way;
};

class CattaneoMindlinSpheres : public testing::TestWithParam<Spheres> {};

TEST_P(CattaneoMindlinSpheres, ShearTractionAndStickZoneConverge) {
  const auto& [slave, poisson, way] = GetParam();
  const Sheared fine = shear_spheres(12, poisson, way, slave), coarse = shear_spheres(6, poisson, way, slave);
  EXPECT_LT(fine.rms, 0.05);
  EXPECT_LT(std::abs(fine.centre), 0.003);
  EXPECT_LT(fine.rms, 0.5 * coarse.rms);
  EXPECT_NEAR(fine.stick, std::pow(1 - fine.ratio, 2.0 / 3), 0.03);  // two nodes at the edge of the stick zone
}

INSTANTIATE_TEST_SUITE_P(Slaves, CattaneoMindlinSpheres,
                         testing::Values(Spheres{"lower_patch", 0, 0.01}, Spheres{"upper_patch", 0.3, 0.02}),
                         [](const auto& of) { return std::string(of.param.slave); });

}  // namespace
}  // namespace friction_hertz_cases
}  // namespace creepcontact
