/// Contact in one sector against contact in the full circle: across the faces of the sector, and of parts of
/// neighbouring sectors with each other.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace cyclic_contact_cases {
namespace {

constexpr int full = 6;
constexpr double pitch = 2 * std::numbers::pi / full;

/// Sectors of a ring between skew cuts. Their numbers are part of the names if they are separate bodies.
struct Ring {
  std::string name;
  double inner, outer;
  double from, skew;  // [rad] of the first cut: at the inner radius, and what the outer end lies further
  int along, across;  // elements of a sector
  bool separate = false;
  double uneven = 1;  // elements of the first cut grow by this factor
  int layers = 0;     // along z, each as thick as one; 0: a section
};

/// Groups of the solid above these quadrilaterals, whose curves are the low, the outer, the high and the inner one.
std::string extruded(const Ring& ring, int sectors, int first_surface) {
  std::string geo = "volumes[] = {}; inner[] = {}; outer[] = {}; low[] = {}; high[] = {};\n";
  for (int s = 0; s < sectors; ++s)
    geo += fmt::format(
        "out[] = Extrude {{0, 0, {0}}} {{ Surface{{{1}}}; Layers{{{0}}}; Recombine; }};\nvolumes[] += out[1]; low[] += "
        "out[2]; outer[] += out[3]; high[] += out[4]; inner[] += out[5];\n",
        ring.layers, first_surface + s);
  geo += fmt::format(
      "Physical Volume(\"{0}\") = {{volumes[]}}; Physical Surface(\"{0}_in\") = {{inner[]}};\n"
      "Physical Surface(\"{0}_out\") = {{outer[]}}; Physical Surface(\"{0}_z0\") = {{{1}:{2}}};\n",
      ring.name, first_surface, first_surface + sectors - 1);
  if (sectors < full)
    geo += fmt::format("Physical Surface(\"{0}_low\") = {{low[]}}; Physical Surface(\"{0}_high\") = {{high[]}};\n",
                       ring.name);
  return geo;
}

/// Groups: <name>, <name>_in, <name>_out; <name>_low and <name>_high of a single sector. Separate sectors: the same of
/// <name>0, <name>1 and so on. Solids also: <name>_z0.
std::string ring_geo(const Ring& ring, int sectors, int first) {
  const auto at = [](double radius, double angle) {
    return fmt::format("{{{:.15g}, {:.15g}, 0}}", radius * std::cos(angle), radius * std::sin(angle));
  };
  std::string geo = fmt::format("Point({}) = {{0, 0, 0}};\n", first);
  const bool closed = sectors == full;
  for (int s = 0; s <= sectors - (closed ? 1 : 0); ++s) {
    const double angle = ring.from + pitch * s;
    geo += fmt::format(
        "Point({0}) = {1}; Point({2}) = {3}; Line({4}) = {{{0}, {2}}}; Transfinite Curve{{{4}}} = {5} Using "
        "Progression {6:g};\n",
        first + 100 + s, at(ring.inner, angle), first + 200 + s, at(ring.outer, angle + ring.skew), first + 300 + s,
        ring.across + 1, s == 0 ? ring.uneven : 1.0);
  }
  for (int s = 0; s < sectors; ++s) {
    const int next = closed ? (s + 1) % full : s + 1;
    geo += fmt::format(
        "Circle({0}) = {{{1}, {12}, {2}}}; Circle({3}) = {{{4}, {12}, {5}}}; Transfinite Curve{{{0}, {3}}} = {11};\n"
        "Curve Loop({6}) = {{{7}, {3}, -{8}, -{0}}}; Plane Surface({6}) = {{{6}}}; Transfinite Surface{{{6}}}; "
        "Recombine Surface{{{6}}};{9}{10}\n",
        first + 400 + s, first + 100 + s, first + 100 + next, first + 500 + s, first + 200 + s, first + 200 + next,
        first + 600 + s, first + 300 + s, first + 300 + next, "", "", ring.along + 1, first);
    if (!ring.separate) continue;
    geo += fmt::format(
        "Physical Surface(\"{0}{1}\") = {{{2}}}; Physical Curve(\"{0}{1}_in\") = {{{3}}};\n"
        "Physical Curve(\"{0}{1}_out\") = {{{4}}}; Physical Curve(\"{0}{1}_low\") = {{{5}}};\n",
        ring.name, s, first + 600 + s, first + 400 + s, first + 500 + s, first + 300 + s);
    geo += fmt::format("Physical Curve(\"{}{}_high\") = {{{}}};\n", ring.name, s, first + 300 + next);
  }
  if (ring.separate) return geo;
  if (ring.layers > 0) return geo + extruded(ring, sectors, first + 600);
  geo += fmt::format(
      "Physical Surface(\"{0}\") = {{{1}:{2}}}; Physical Curve(\"{0}_in\") = {{{3}:{4}}};\n"
      "Physical Curve(\"{0}_out\") = {{{5}:{6}}};\n",
      ring.name, first + 600, first + 600 + sectors - 1, first + 400, first + 400 + sectors - 1, first + 500,
      first + 500 + sectors - 1);
  if (!closed)
    geo += fmt::format("Physical Curve(\"{0}_low\") = {{{1}}}; Physical Curve(\"{0}_high\") = {{{2}}};\n", ring.name,
                       first + 300, first + 301);
  return geo;
}

std::string cyclic(const std::string& name) {
  return fmt::format("[[cyclic]]\nbetween = [\"{0}_low\", \"{0}_high\"]\nangle = {1}\n", name, 360 / full);
}

std::string both(const Ring& first, const Ring& second, int sectors) {
  return ring_geo(first, sectors, 1000) + ring_geo(second, sectors, 2000);
}

/// @param extensive  probes that grow with the number of sectors
void expect_same(const test::Table& one, const test::Table& all, const std::vector<std::string>& probes,
                 const std::vector<std::string>& extensive, double elastic = 1e-8) {
  const auto compare = [&](const std::string& probe, double factor) {
    EXPECT_RELATIVE(factor * one.at(probe, 0), all.at(probe, 0), elastic) << probe;
    EXPECT_RELATIVE(factor * one.at(probe, 1000), all.at(probe, 1000), 2e-4) << probe << ": the steps differ";
  };
  for (const std::string& probe : probes) compare(probe, 1);
  for (const std::string& probe : extensive) compare(probe, full);
}

const Ring hub{"hub", 3, 6, 0.35, -0.2, 7, 4}, ring{"ring", 6, 9, 0, 0.4, 5, 3};

std::string press_fit(const std::string& contact, const std::string& load) {
  return test::section_of("plane_strain") + test::body("hub", 1000, 0.3) + test::body("ring", 800, 0.3, 1e-7, 3) +
         "[time]\nend = 1000\n[[supports]]\non = \"hub_in\"\ndisplacement = { x = 0, y = 0 }\n[[contacts]]\n"
         "name = \"fit\"\nbetween = [\"hub_out\", \"ring_in\"]\n" +
         contact + load + test::probe("mean", "contact_pressure", "on = \"ring_in\"\nreduce = \"mean\"") +
         test::probe("max", "contact_pressure", "on = \"hub_out\"\nreduce = \"max\"") +
         test::probe("min", "contact_pressure", "on = \"hub_out\"\nreduce = \"min\"") +
         test::probe("area", "contact_area", "on = \"hub_out\"\nreduce = \"sum\"") +
         test::probe("stress", "von_mises", "body = \"ring\"\nreduce = \"max\"");
}

class PressFitOfSectors : public testing::TestWithParam<const char*> {};

TEST_P(PressFitOfSectors, IsThatOfTheFullCircle) {
  const std::string toml = press_fit(fmt::format("gap = \"-0.03*(1 + 0.4*sin(6*atan2(y, x)))\"\n{}", GetParam()),
                                     "[[loads]]\non = \"ring_out\"\npressure = \"2 + sin(6*atan2(y, x))\"\n");
  const test::Outcome all = test::run_case(toml, both(hub, ring, full));
  const test::Outcome one = test::run_case(toml + cyclic("hub") + cyclic("ring"), both(hub, ring, 1));
  expect_same(one.history, all.history, {"mean", "max", "min", "stress"}, {"area"});
  EXPECT_GT(all.history.at("max", 0), 1.2 * all.history.at("min", 0));
}

INSTANTIATE_TEST_SUITE_P(Slaves, PressFitOfSectors,
                         testing::Values("slave = \"hub_out\"\n", "slave = \"ring_in\"\n",
                                         "slave = \"ring_in\"\nfriction = 0.05\n"));

/// Friction in three dimensions, and loads that change around the circle and along the axis.
TEST(CyclicContact, SolidSectorIsAPartOfTheSolid) {
  const Ring below{"hub", 4, 6, 0.35, -0.2, 4, 2, false, 1, 2}, above{"ring", 6, 8, 0, 0.3, 3, 2, false, 1, 3};
  const std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + test::body("hub", 1000, 0.3) +
      test::body("ring", 800, 0.3, 1e-7, 3) + test::support("hub_z0", "z") + test::support("hub_in", "x") +
      test::support("hub_in", "y") +
      "[time]\nend = 1000\n[[contacts]]\nname = \"fit\"\nbetween = [\"hub_out\", \"ring_in\"]\nslave = \"ring_in\"\n"
      "friction = 0.2\ngap = -0.03\n[[loads]]\non = \"ring_out\"\npressure = \"2 + z + sin(6*atan2(y, x))\"\n"
      "[[loads]]\non = \"ring_out\"\ntraction = [\"-0.01*y\", \"0.01*x\", 0.2]\n[[loads]]\nbody = \"ring\"\nrotation = "
      "{ angular_velocity = 0.2, density = 0.1 }\n" +
      test::probe("mean", "contact_pressure", "on = \"ring_in\"\nreduce = \"mean\"") +
      test::probe("max", "contact_pressure", "on = \"ring_in\"\nreduce = \"max\"") +
      test::probe("shear", "contact_shear", "on = \"ring_in\"\nreduce = \"max\"") +
      test::probe("axial", "contact_force_z", "on = \"ring_in\"\nwhere = \"z > 1.5\"") +
      test::probe("held", "reaction_z", "on = \"hub_z0\"") +
      test::probe("part", "contact_pressure", "on = \"ring_in\"\nreduce = \"mean\"\nwhere = \"z > 1.5\"") +
      test::probe("stress", "von_mises", "body = \"ring\"\nreduce = \"max\"");
  const test::Outcome all = test::run_case(toml, both(below, above, full));
  const test::Outcome one = test::run_case(toml + cyclic("hub") + cyclic("ring"), both(below, above, 1));
  expect_same(one.history, all.history, {"mean", "max", "shear", "part", "stress"}, {"axial", "held"}, 1e-7);
}

/// Both yield where the fit is tightest, at once and while the load grows; with friction too.
TEST(CyclicContact, YieldsAsInTheFullCircle) {
  const std::vector<std::string> yielding{"materials.hub.plasticity={yield_stress=3,hardening_modulus=20}",
                                          "materials.ring.plasticity={yield_stress=4,kinematic=[{C=100,gamma=50}]}",
                                          "time.tolerance=1e-5", "time.end=2", "time.output=[1]"};
  for (const char* friction : {"", "friction = 0.1\n"}) {
    const std::string toml =
        press_fit(std::string("gap = \"-0.03*(1 + 0.4*sin(6*atan2(y, x)))\"\nslave = \"ring_in\"\n") + friction,
                  "[[loads]]\non = \"ring_out\"\npressure = \"(2 + sin(6*atan2(y, x)))*(1 + t)\"\n") +
        test::probe("hub_flow", "plastic_strain_equivalent", "body = \"hub\"\nreduce = \"max\"") +
        test::probe("ring_flow", "plastic_strain_equivalent", "body = \"ring\"\nreduce = \"max\"");
    const test::Outcome all = test::run_case(toml, both(hub, ring, full), yielding);
    const test::Outcome one = test::run_case(toml + cyclic("hub") + cyclic("ring"), both(hub, ring, 1), yielding);
    for (const char* name : {"mean", "max", "min", "stress", "hub_flow", "ring_flow"})
      for (const double t : {0.0, 1.0, 2.0})
        EXPECT_RELATIVE(one.history.at(name, t), all.history.at(name, t), 1e-4) << name << t << friction;
    EXPECT_GT(all.history.at("hub_flow", 2), all.history.at("hub_flow", 0));
    EXPECT_GT(all.history.at("ring_flow", 2), all.history.at("ring_flow", 0));
  }
}

/// Contact opens over a part of each sector, at both of its faces.
TEST(CyclicContact, OpensAsInTheFullCircle) {
  const std::string toml = press_fit("gap = \"-0.002 + 0.02*cos(6*atan2(y, x))\"\nslave = \"ring_in\"\n",
                                     "[[loads]]\non = \"ring_out\"\npressure = 0.5\n");
  const test::Outcome all = test::run_case(toml, both(hub, ring, full));
  const test::Outcome one = test::run_case(toml + cyclic("hub") + cyclic("ring"), both(hub, ring, 1));
  expect_same(one.history, all.history, {"max", "stress"}, {"area"});
  EXPECT_EQ(all.history.at("min", 0), 0);
  EXPECT_LT(all.history.at("area", 0), 24) << "of 37.7";
}

/// Faces whose nodes do not match are tied, up to the surfaces in contact.
TEST(CyclicContact, FacesThatDoNotMatch) {
  Ring uneven_hub = hub, uneven_ring = ring;
  uneven_hub.uneven = uneven_ring.uneven = 1.3;
  const std::string toml = press_fit("gap = \"-0.03*(1 + 0.4*sin(6*atan2(y, x)))\"\nslave = \"ring_in\"\n",
                                     "[[loads]]\non = \"ring_out\"\npressure = \"2 + sin(6*atan2(y, x))\"\n");
  const test::Outcome all = test::run_case(toml, both(hub, ring, full));
  const test::Outcome one = test::run_case(toml + cyclic("hub") + cyclic("ring"), both(uneven_hub, uneven_ring, 1));
  for (const double t : {0.0, 1000.0}) {
    EXPECT_RELATIVE(one.history.at("mean", t), all.history.at("mean", t), 1e-3) << t;
    EXPECT_RELATIVE(one.history.at("max", t), all.history.at("max", t), 0.03) << t << ": the mesh differs";
    EXPECT_RELATIVE(full * one.history.at("area", t), all.history.at("area", t), 1e-6) << t;
  }
}

/// Segments around a hub press on it and, at skew faces, on each other.
TEST(CyclicContact, SegmentsPressOnThoseOfTheNextSector) {
  const Ring segments{"segment", 6, 9, 0, 0.4, 5, 3, true};
  const std::string toml =
      test::section_of("plane_strain") + test::body("hub", 1000, 0.3) +
      "[time]\nend = 1000\n[[supports]]\non = \"hub_in\"\ndisplacement = { x = 0, y = 0 }\n" +
      test::probe("stress", "von_mises", "body = \"segment0\"\nreduce = \"max\"") +
      test::probe("foot", "contact_pressure", "on = \"segment0_in\"\nreduce = \"max\"") +
      test::probe("side", "contact_pressure", "on = \"segment0_low\"\nbody = \"segment0\"\nreduce = \"mean\"") +
      test::probe("side_x", "contact_force_x", "on = \"segment0_low\"\nbody = \"segment0\"\nreduce = \"sum\"") +
      test::probe("side_y", "contact_force_y", "on = \"segment0_low\"\nbody = \"segment0\"\nreduce = \"sum\"") +
      test::probe("foot_y", "contact_force_y", "on = \"segment0_in\"\nreduce = \"sum\"");
  const auto segment = [](int s, const std::string& neighbour) {
    return test::body(fmt::format("segment{}", s), 800, 0.3, 1e-7, 3) +
           fmt::format(
               "[[loads]]\non = \"segment{0}_out\"\npressure = \"12 + 3*sin(6*atan2(y, x))\"\n"
               "[[contacts]]\nname = \"foot{0}\"\nbetween = [\"segment{0}_in\", \"hub_out\"]\nfriction = 0.2\n"
               "gap = -0.005\nslave = \"segment{0}_in\"\n"
               "[[contacts]]\nname = \"side{0}\"\nbetween = {1}\ngap = -0.01\n",
               s, neighbour);
  };
  std::string of_all = toml;
  for (int s = 0; s < full; ++s)
    of_all += segment(s, fmt::format("[\"segment{}_high\", \"segment{}_low\"]", s, (s + 1) % full));
  const test::Outcome all = test::run_case(of_all, both(hub, segments, full));
  const test::Outcome one = test::run_case(toml + segment(0, "[\"segment0_high\", \"segment0_low\"]") + cyclic("hub"),
                                           both(hub, segments, 1));
  expect_same(one.history, all.history, {"stress", "foot", "side", "side_x", "side_y", "foot_y"}, {}, 1e-6);
}

}  // namespace
}  // namespace cyclic_contact_cases
}  // namespace creepcontact
