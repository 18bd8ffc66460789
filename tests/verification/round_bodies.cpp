#include "verification/round_bodies.hpp"

#include <fmt/format.h>

namespace creepcontact::test {

std::string round_on_block_geo(const RoundOnBlock& bodies) {
  const double R = bodies.radius, e = 1e-5, y = bodies.sphere ? R : bodies.width;
  std::string geo = "SetFactory(\"OpenCASCADE\");\n";
  if (bodies.sphere)
    geo += fmt::format(
        "Sphere(1) = {{0, 0, {0}, {0}, -Pi/2, 0, Pi/2}}; Box(2) = {{0, 0, -{0}, {0}, {0}, {0}}}; round = 1;\n", R);
  else
    geo += fmt::format(R"(
      Point(1) = {{0, 0, 0}}; Point(2) = {{{0}, 0, {0}}}; Point(3) = {{0, 0, {0}}};
      Circle(1) = {{1, 3, 2}}; Line(2) = {{2, 3}}; Line(3) = {{3, 1}};
      Point(11) = {{0, 0, 0}}; Point(12) = {{0, 0, -{0}}}; Point(13) = {{{0}, 0, -{0}}}; Point(14) = {{{0}, 0, 0}};
      Line(11) = {{11, 12}}; Line(12) = {{12, 13}}; Line(13) = {{13, 14}}; Line(14) = {{14, 11}};
      Line Loop(1) = {{1, 2, 3}}; Plane Surface(1) = {{1}};
      Line Loop(2) = {{11, 12, 13, 14}}; Plane Surface(2) = {{2}};
      a[] = Extrude {{0, {1}, 0}} {{ Surface{{1}}; Layers{{1}}; Recombine; }};
      b[] = Extrude {{0, {1}, 0}} {{ Surface{{2}}; Layers{{1}}; Recombine; }};
      round = a[2];
    )",
                       R, bodies.width);
  geo += fmt::format(R"geo(
    Field[1] = MathEval; Field[1].F = "{0} + 0.25*Max(0, Sqrt(x*x + {2} + z*z) - {1})";
    Background Field = 1; Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0;
    Mesh.CharacteristicLengthExtendFromBoundary = 0; Mesh.CharacteristicLengthFromPoints = 0;
    Mesh.CharacteristicLengthMin = {0}; Physical Volume("upper") = {{1}}; Physical Volume("lower") = {{2}};
  )geo",
                     bodies.size, bodies.fine, bodies.sphere ? "y*y" : "0");
  const auto group = [&](const std::string& name, double xa, double xb, double ya, double yb, double za, double zb) {
    geo += fmt::format("{} = Surface In BoundingBox{{{}, {}, {}, {}, {}, {}}};\n", name, xa - e, ya - e, za - e, xb + e,
                       yb + e, zb + e);
  };
  const auto named = [](const std::string& name) { return "Physical Surface(\"" + name + "\")"; };
  group(named("upper_x0"), 0, 0, 0, y, 0, R);
  group(named("lower_x0"), 0, 0, 0, y, -R, 0);
  group(named("upper_y0"), 0, R, 0, 0, 0, R);
  group(named("lower_y0"), 0, R, 0, 0, -R, 0);
  group(named("upper_far"), 0, R, 0, y, R, R);
  group(named("lower_far"), 0, R, 0, y, -R, -R);
  group(named("lower_top"), 0, R, 0, y, 0, 0);
  if (!bodies.sphere) {
    group(named("upper_back"), 0, R, y, y, 0, R);
    group(named("lower_back"), 0, R, y, y, -R, 0);
  }
  return geo + "Physical Surface(\"upper_round\") = {round};\n";
}

}  // namespace creepcontact::test
