/// Cyclic symmetry and rigid surfaces: one sector against the full circle, and closed forms.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace cyclic_cases {
namespace {

constexpr double inner = 6, outer = 10, modulus = 1000, poisson_ratio = 0.3;
constexpr int n_sectors = 6;

/// Sectors of a ring between skew cuts. Groups: ring, bore, rim, and of a single one low and high.
/// @param digits  of the coordinates
std::string ring_geo(int n, int along_high = 5, int digits = 15) {
  std::string geo = "c = newp; Point(c) = {0, 0, 0};\n";
  for (int s = 0; s <= n; ++s) {
    if (s == n_sectors) break;
    const double angle = 2 * std::numbers::pi * s / n_sectors, skew = angle + 0.4;
    geo += fmt::format("Point({0}) = {{{1:.{6}g}, {2:.{6}g}, 0}}; Point({3}) = {{{4:.{6}g}, {5:.{6}g}, 0}};\n", 100 + s,
                       inner * std::cos(angle), inner * std::sin(angle), 200 + s, outer * std::cos(skew),
                       outer * std::sin(skew), digits);
    geo += fmt::format("Line({0}) = {{{1}, {2}}}; Transfinite Curve{{{0}}} = {3};\n", 300 + s, 100 + s, 200 + s,
                       s == n && n < n_sectors ? along_high : 5);
  }
  const bool structured = along_high == 5;
  for (int s = 0; s < n; ++s) {
    const int next = (s + 1) % n_sectors;
    geo += fmt::format(
        "Circle({0}) = {{{1}, c, {2}}}; Circle({3}) = {{{4}, c, {5}}}; Transfinite Curve{{{0}, {3}}} = 7;\n"
        "Curve Loop({6}) = {{{7}, {3}, -{8}, -{0}}}; Plane Surface({6}) = {{{6}}};{9} Recombine Surface{{{6}}};\n",
        400 + s, 100 + s, 100 + next, 500 + s, 200 + s, 200 + next, 600 + s, 300 + s, 300 + next,
        structured ? fmt::format(" Transfinite Surface{{{}}};", 600 + s) : "");
  }
  geo += fmt::format(
      "Physical Surface(\"ring\") = {{600:{0}}}; Physical Curve(\"bore\") = {{400:{1}}}; Physical Curve(\"rim\") = "
      "{{500:{2}}};\n",
      600 + n - 1, 400 + n - 1, 500 + n - 1);
  if (n < n_sectors) geo += "Physical Curve(\"low\") = {300}; Physical Curve(\"high\") = {301};\n";
  return geo;
}

const std::string sector_keys = "[[cyclic]]\nbetween = [\"low\", \"high\"]\nangle = 60\n";

/// Displacements of a corner of the first sector.
std::string corner_probes() {
  const std::string at = fmt::format("at = [{:.15g}, {:.15g}, 0]", outer * std::cos(0.4), outer * std::sin(0.4));
  return test::probe("x", "displacement_x", at) + test::probe("y", "displacement_y", at);
}

/// Along the circumference.
double round(const test::Table& history, double t) {
  return history.at("y", t) * std::cos(0.4) - history.at("x", t) * std::sin(0.4);
}

std::string ring(const std::string& more) {
  return test::section_of("plane_strain") + test::body("ring", modulus, poisson_ratio, 1e-8, 3) +
         "[time]\nend = 1000\n" + test::probe("stress", "von_mises", "on = \"bore\"\nreduce = \"max\"") +
         corner_probes() + more;
}

/// A plane through the axis.
std::string section_at(double angle) {
  return fmt::format("body = \"ring\"\nsection = {{ origin = [0, 0, 0], normal = [{:.15g}, {:.15g}, 0] }}",
                     -std::sin(angle), std::cos(angle));
}

/// Loads with the period of a sector, without a plane of symmetry.
const std::string loads =
    "[[loads]]\non = \"rim\"\npressure = \"8 + 3*sin(6*atan2(y, x))\"\n"
    "[[loads]]\non = \"rim\"\ntraction = [\"-0.4*y\", \"0.4*x\", 0]\n"
    "[[loads]]\nbody = \"ring\"\nrotation = { angular_velocity = 0.5, density = 0.1 }\n"
    "[[supports]]\non = \"bore\"\ndisplacement = { x = 0, y = 0 }\n";

TEST(Cyclic, SectorIsAPartOfTheRing) {
  const test::Table all = test::run_case(ring(loads), ring_geo(n_sectors)).history;
  const test::Table one = test::run_case(ring(loads) + sector_keys, ring_geo(1)).history;
  for (const char* probe : {"stress", "x", "y"}) {
    EXPECT_RELATIVE(one.at(probe, 0), all.at(probe, 0), 1e-9) << probe;
    EXPECT_RELATIVE(one.at(probe, 1000), all.at(probe, 1000), 1e-4) << probe << ": the steps differ";
  }
  const test::Table mortar = test::run_case(ring(loads) + sector_keys, ring_geo(1, 9)).history;
  for (const char* probe : {"x", "y"})
    for (const double t : {0.0, 1000.0}) EXPECT_RELATIVE(mortar.at(probe, t), all.at(probe, t), 2e-3) << probe << t;
}

/// A rim that is warm in one half of each sector and cold in the other one drives heat across the cuts.
TEST(Cyclic, HeatCrossesTheFacesOfASector) {
  const auto temperatures = [](const std::string& cyclic, const std::string& geo) {
    const std::string toml =
        test::section_of("plane_strain") +
        "[materials.steel]\nconductivity = 2\n[bodies.ring]\nregion = \"ring\"\nmaterial = \"steel\"\n" +
        "[heat]\nstart = \"steady\"\ntemperatures = [{ on = \"bore\", value = 50 }]\n"
        "films = [{ on = \"rim\", coefficient = 5, fluid = \"100 + 80*sin(6*atan2(y, x))\" }]\n[time]\nend = 0\n" +
        test::probe("corner", "temperature",
                    fmt::format("at = [{:.15g}, {:.15g}, 0]", outer * std::cos(0.4), outer * std::sin(0.4)));
    return test::run_case(toml + cyclic, geo);
  };
  const double all = temperatures("", ring_geo(n_sectors)).history.at("corner", 0);
  EXPECT_RELATIVE(temperatures(sector_keys, ring_geo(1)).history.at("corner", 0), all, 1e-9);
  const test::Outcome unmatched = temperatures(sector_keys, ring_geo(1, 9));
  EXPECT_RELATIVE(unmatched.history.at("corner", 0), all, 2e-3);
  const double insulated = temperatures("", ring_geo(1)).history.at("corner", 0);
  EXPECT_GT(std::abs(insulated - all), 0.02 * all) << "the cuts matter";
}

/// A rigid rim turns by an angle: u_theta = angle (r - a^2/r)/(1 - a^2/b^2)/b, torque 4 pi G angle a^2/(1 - a^2/b^2).
TEST(Cyclic, RigidRimTurnsTheSector) {
  constexpr double angle = 1e-3;
  const double shear = modulus / (2 * (1 + poisson_ratio));
  const double torque = 4 * std::numbers::pi * shear * angle / (1 / (inner * inner) - 1 / (outer * outer)) / n_sectors;
  const std::string elastic = test::section_of("plane_strain") + test::body("ring", modulus, poisson_ratio) +
                              "[time]\nend = 1\n" + corner_probes() +
                              "[[supports]]\non = \"bore\"\ndisplacement = { x = 0, y = 0 }\n" + sector_keys +
                              "[[rigid]]\non = \"rim\"\norigin = [0, 0, 0]\n";
  const test::Table turned =
      test::run_case(elastic + fmt::format("rotation = {{ z = {} }}\n", angle), ring_geo(1)).history;
  EXPECT_RELATIVE(round(turned, 1), angle * outer, 1e-4);
  const test::Table loaded =
      test::run_case(elastic + fmt::format("moment = [0, 0, {:.12g}]\n", torque), ring_geo(1)).history;
  EXPECT_RELATIVE(round(loaded, 1), angle * outer, 1e-3);
}

/// Half of a rotating ring pulls at its two sections with rho omega^2 (b^3 - a^3)/3 each; the cut faces of the sector
/// carry it on.
TEST(Cyclic, SectionOfASectorCarriesTheHoopForce) {
  constexpr double angle = 0.7, density = 0.1, velocity = 0.5;
  const test::Table history =
      test::run_case(
          test::section_of("plane_strain") + test::body("ring", modulus, poisson_ratio) +
              fmt::format("[time]\nend = 1\n[[loads]]\nbody = \"ring\"\nrotation = {{ angular_velocity = {}, "
                          "density = {} }}\n",
                          velocity, density) +
              "[[supports]]\non = \"origin\"\ndisplacement = { y = 0 }\n" + sector_keys +
              test::probe("x", "section_force_x", section_at(angle)) +
              test::probe("y", "section_force_y", section_at(angle)) +
              test::probe("held", "reaction_y", "on = \"origin\""),
          ring_geo(1) + "Physical Point(\"origin\") = {100};\n")
          .history;
  const double force = density * velocity * velocity * (std::pow(outer, 3) - std::pow(inner, 3)) / 3;
  EXPECT_RELATIVE(history.at("x", 1), -force * std::sin(angle), 2e-5);
  EXPECT_RELATIVE(history.at("y", 1), force * std::cos(angle), 2e-5);
  EXPECT_NEAR(history.at("held", 1), 0, 1e-9 * force) << "of a node that the cut passes through";
}

/// Also where the nodes match to seven digits only.
TEST(Cyclic, MotionsOfASectorAreRecognised) {
  for (const int digits : {15, 7}) {
    const std::string message = test::message_of<std::exception>([&] {
      test::run_case(test::section_of("plane_strain") + test::body("ring", modulus, poisson_ratio) +
                         "[time]\nend = 1\n" + sector_keys + "[[loads]]\non = \"rim\"\ntraction = [\"-y\", \"x\", 0]\n",
                     ring_geo(1, 5, digits));
    });
    EXPECT_TRUE(test::says(message, {"body 'ring'", "rotation", "(0, 0, 1)", "(0, 0, 0)"}));
    EXPECT_EQ(message.find("translation"), std::string::npos) << message;
  }
}

TEST(Cyclic, FacesInTheWrongOrderAreNamed) {
  const std::string message = test::message_of<ModelError>(
      [&] { test::run_case(ring(loads) + "[[cyclic]]\nbetween = [\"high\", \"low\"]\nangle = 60\n", ring_geo(1)); });
  EXPECT_TRUE(test::says(message, {"'low'", "'high'", "-60", " 60:"}));
}

TEST(Cyclic, WrongAngleIsNamed) {
  const std::string message = test::message_of<ModelError>(
      [&] { test::run_case(ring(loads) + "[[cyclic]]\nbetween = [\"low\", \"high\"]\nangle = 45\n", ring_geo(1)); });
  EXPECT_TRUE(test::says(message, {"'low'", "45 degrees", "'high'", "60 degrees"}));
}

/// A bar with a rigid end plate under a moment bends to a circle; the plate's tilt is M L/(E I).
TEST(Rigid, PlateTiltsUnderAMoment) {
  constexpr double length = 8, moment = 0.6, force = 0.3;
  const std::string geo = test::boxes_geo({{"bar", {0, -0.5, -0.5}, {length, 1, 1}, {16, 2, 2}}});
  const std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("bar", modulus, 0) + test::support("bar_x0", "x") +
      test::support("bar_x0", "y") + test::support("bar_x0", "z") + "[time]\nend = 1\n" +
      test::probe("z", "displacement_z", "on = \"bar_x1\"") + test::probe("x", "displacement_x", "on = \"bar_x1\"") +
      test::probe("top", "displacement_x", "on = \"bar_x1\"\nreduce = \"max\"") + "[[rigid]]\non = \"bar_x1\"\n";
  const test::Table bent =
      test::run_case(toml + fmt::format("moment = [0, \"-{0}\", 0]\nforce = [{1}, 0, 0]\n", moment, force), geo)
          .history;
  constexpr double inertia = 1.0 / 12;
  EXPECT_RELATIVE(bent.at("x", 1), force * length / modulus, 1e-6);
  EXPECT_RELATIVE(bent.at("z", 1), moment * length * length / (2 * modulus * inertia), 1e-6);
  EXPECT_RELATIVE(bent.at("top", 1) - bent.at("x", 1), moment * length / (modulus * inertia) * 0.5, 1e-6);
  // The same motion prescribed.
  const test::Table moved =
      test::run_case(toml +
                         fmt::format("displacement = {{ x = {:.15g}, y = 0, z = {:.15g} }}\n"
                                     "rotation = {{ x = 0, y = {:.15g}, z = 0 }}\n",
                                     bent.at("x", 1), bent.at("z", 1), -moment * length / (modulus * inertia)) +
                         test::probe("held", "reaction_x", "on = \"bar_x0\""),
                     geo)
          .history;
  EXPECT_RELATIVE(moved.at("held", 1), -force, 1e-6);
}

}  // namespace
}  // namespace cyclic_cases
}  // namespace creepcontact
