/// Assemblies that contact alone holds together: no supports but symmetry, or none at all.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxes.hpp"
#include "case.hpp"
#include "rings.hpp"
#include "support/says.hpp"

namespace creepcontact::test {
namespace {

/// Two rings that nothing supports: the interference holds them to each other, and they may turn and shift.
TEST(FloatingRings, PressEachOtherAsLameSays) {
  constexpr double inner = 6, radius = 10, outer = 15, interference = 0.02, modulus = 2e5;
  const double exact = modulus * interference / (2 * std::pow(radius, 3)) * (outer * outer - radius * radius) *
                       (radius * radius - inner * inner) / (outer * outer - inner * inner);
  const std::string geo = full_rings_geo({{"shaft", inner, radius, 4 * 8}, {"ring", radius, outer, 4 * 11}}, 0.6, 0.5);
  for (const char* slave : {"shaft_outer", "ring_inner"}) {
    SCOPED_TRACE(slave);
    const std::string toml =
        "[mesh]\nfile = \"case.geo\"\norder = 1\n" + body("shaft", modulus, 0.3) + body("ring", modulus, 0.3) +
        contact_table("shaft_outer", "ring_inner", fmt::format("gap = -{}\nslave = \"{}\"", interference, slave)) +
        "[time]\nend = 1\n" + probe("mean", "contact_pressure", "on = \"shaft_outer\"") +
        probe("least", "contact_pressure", "on = \"shaft_outer\"\nreduce = \"min\"") +
        probe("most", "contact_pressure", "on = \"shaft_outer\"\nreduce = \"max\"") +
        probe("x", "contact_force_x", "on = \"shaft_outer\"") + probe("z", "contact_force_z", "on = \"shaft_outer\"") +
        probe("shift", "displacement_z", "on = \"ring_outer\"");
    const Table history = run_case(toml, geo).history;
    EXPECT_RELATIVE(history.at("mean", 1), exact, 0.01);
    EXPECT_RELATIVE(history.at("least", 1), exact, 0.02);
    EXPECT_RELATIVE(history.at("most", 1), exact, 0.02);
    EXPECT_NEAR(history.at("x", 1), 0, 1e-9 * exact);
    EXPECT_NEAR(history.at("z", 1), 0, 1e-9 * exact);
    EXPECT_NEAR(history.at("shift", 1), 0, 0.1 * interference) << "unconstrained motions leave the ring where it is";
  }
}

/// Half of a bolt with two heads (its axis at x = 3.2 is a plane of symmetry) that clamps two plates.
std::string clamp_geo() {
  std::string geo =
      boxes_geo({{"lower", {0, 0, -2}, {2, 1, 2}, {3, 2, 2}}, {"upper", {0, 0, 0}, {2, 1, 2}, {4, 2, 2}}});
  return geo + R"(
    xs[] = {3.2, 3.2, 0.2, 0.2, 2.2, 2.2, 0.2, 0.2}; zs[] = {-3, 3, 3, 2, 2, -2, -2, -3};
    corner[] = {}; edge[] = {};
    For i In {0:7}
      a = newp; Point(a) = {xs[i], 0, zs[i]}; corner[] += {a};
    EndFor
    For i In {0:7}
      l = newl; Line(l) = {corner[i], corner[(i + 1) % 8]}; edge[] += {l};
    EndFor
    k = newll; Curve Loop(k) = {edge[]}; u = news; Plane Surface(u) = {k};
    b[] = Extrude {0, 1, 0} { Surface{u}; };
    e = 1e-6;
    Physical Volume("bolt") = {b[1]};
    Physical Surface("bolt_middle") = Surface In BoundingBox{3.2 - e, -2, -4, 3.2 + e, 2, 4};
    Physical Surface("head") = Surface In BoundingBox{0.2 - e, -2, 2 - e, 2.2 + e, 2, 2 + e};
    Physical Surface("foot") = Surface In BoundingBox{0.2 - e, -2, -2 - e, 2.2 + e, 2, -2 + e};
    MeshSize{:} = 0.45; Mesh.ElementOrder = 2;
  )";
}

std::string clamp_toml() {
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + body("lower", 2e5, 0.3) + body("upper", 1e5, 0.3) +
                     body("bolt", 2e5, 0.3) + support("bolt_middle", "x");
  toml += contact_table("lower_z1", "upper_z0") + contact_table("foot", "lower_z0") +
          contact_table("head", "upper_z1", "gap = -0.01");  // the preload
  for (const auto& [plate, sign] : {std::pair{"upper", ""}, std::pair{"lower", "-"}})
    toml += fmt::format("[[loads]]\nbody = \"{}\"\nbody_force = [0, 0, \"{}30*min(t, 4 - t)\"]\n", plate, sign);
  toml += "[time]\nend = 4\noutput = [0, 0.5, 1, 2, 3, 3.5, 4]\nbreakpoints = [2]\n";
  for (const auto& [name, surface] : {std::pair{"bolt", "head"}, {"joint", "upper_z0"}, {"foot", "foot"}})
    toml += probe(name, "contact_force_z", fmt::format("on = \"{}\"", surface));
  return toml;
}

/// Preload, an external load that pulls the plates apart until they separate, and back. Every force follows from
/// equilibrium but the preload and its share of the external load.
TEST(BoltedStack, CarriesTheLoadBeyondSeparation) {
  const Table history = run_case(clamp_toml(), clamp_geo()).history;
  const double preload = history.at("bolt", 0);
  EXPECT_GT(preload, 0);
  for (const double t : {0.0, 0.5, 1.0, 2.0, 3.0, 3.5, 4.0}) {
    const double load = 30 * std::min(t, 4 - t) * 4;  // on a plate of volume 4
    const double bolt = history.at("bolt", t), joint = history.at("joint", t);
    EXPECT_NEAR(history.at("foot", t), -bolt, 1e-9 * preload) << t;
    EXPECT_NEAR(bolt, joint + load, 1e-9 * preload) << t;
    EXPECT_GE(joint, 0) << t;
  }
  EXPECT_LT(history.at("bolt", 0.5) - preload, 0.6 * 60) << "the joint unloads while the bolt is loaded";
  EXPECT_EQ(history.at("joint", 2), 0) << "the load is beyond the preload: separated";
  EXPECT_RELATIVE(history.at("bolt", 2), 240.0, 1e-9);
  EXPECT_RELATIVE(history.at("bolt", 4), preload, 1e-9);
  EXPECT_RELATIVE(history.at("bolt", 3), history.at("bolt", 1), 1e-9);
}

TEST(BoltedStack, SolversAgree) {
  const std::string geo = clamp_geo();
  const Table reference = run_case(clamp_toml(), geo, {"contact_solver.method=active_set"}).history;
  for (const char* way : {"contact_solver.dense_limit_mb=0", "contact_solver.acceleration=none"}) {
    testing::internal::CaptureStderr();
    const Table other = run_case(clamp_toml(), geo, {way}).history;
    testing::internal::GetCapturedStderr();  // sweeps may hand over to conjugate gradients
    for (const double t : {0.0, 1.0, 2.0, 4.0})
      for (const char* force : {"bolt", "joint"})
        EXPECT_NEAR(other.at(force, t), reference.at(force, t), 1e-7 * reference.at("bolt", t)) << way << ", " << t;
  }
}

/// A stiff, almost incompressible block between soft ones, heated and held by contact alone. The nodal forces of its
/// thermal strain are 1e14 times the load, which must reach the foot all the same.
TEST(HeatedStack, CarriesASmallLoad) {
  const std::string geo = boxes_geo({{"low", {0, 0, 0}, {1, 1, 1}, {3, 3, 3}},
                                     {"middle", {0, 0, 1}, {1, 1, 1}, {3, 3, 3}},
                                     {"up", {0, 0, 2}, {1, 1, 1}, {3, 3, 3}}});
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n[temperature]\nvalue = 20\n[time]\nend = 1\n";
  for (const std::string name : {"low", "middle", "up"}) {
    const bool stiff = name == "middle";
    toml += body(name, stiff ? 7.7e8 : 1e5, stiff ? 0.4999999 : 0.3);
    // the same strain everywhere: the blocks stay flat
    toml.insert(toml.rfind("young_modulus"), "thermal_expansion = 1e-5\nreference_temperature = 0\n");
    toml += support(name + "_x0", "x") + support(name + "_y0", "y");
  }
  toml += support("low_z0", "z") + contact_table("low_z1", "middle_z0") + contact_table("middle_z1", "up_z0");
  for (const std::string name : {"low_z1", "up_z0"}) toml += probe(name, "contact_force_z", "on = \"" + name + "\"");
  toml += probe("foot", "reaction_z", "on = \"low_z0\"");
  for (const char* loaded : {"up_z1", "middle_z1"}) {
    SCOPED_TRACE(loaded);
    testing::internal::CaptureStderr();
    const Table history = run_case(toml + "[[loads]]\non = \"" + loaded + "\"\npressure = 0.2\n", geo).history;
    const std::string warnings = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(says(warnings, {"body 'middle'", "Poisson", "0.4999999", "0.4999 "}));
    EXPECT_EQ(warnings.find("body 'low': Poisson"), std::string::npos) << warnings;
    EXPECT_RELATIVE(history.at("foot", 1), 0.2, 1e-6);
    EXPECT_RELATIVE(history.at("low_z1", 1), -0.2, 1e-6);
    EXPECT_NEAR(history.at("up_z0", 1), loaded == std::string("up_z1") ? 0.2 : 0, 1e-6);
  }
}

}  // namespace
}  // namespace creepcontact::test
