#include "verification/rings.hpp"

#include <fmt/format.h>

namespace creepcontact::test {
namespace {

std::string full_ring(const std::string& name, double inner, double outer, int around, double thickness) {
  return fmt::format(R"(
    c = newp; Point(c) = {{0, 0, 0}}; loops[] = {{}};
    radius[] = {{{1}, {0}}};
    For k In {{0:1}}
      p = newp;
      For i In {{0:3}}
        Point(p + i) = {{radius[k]*Cos(i*Pi/2), radius[k]*Sin(i*Pi/2), 0}};
      EndFor
      l = newl;
      For i In {{0:3}}
        Circle(l + i) = {{p + i, c, p + (i + 1) % 4}};
      EndFor
      Transfinite Curve{{l:l + 3}} = {3} + 1;
      loop = newll; Curve Loop(loop) = {{l:l + 3}}; loops[] += {{loop}};
    EndFor
    s = news; Plane Surface(s) = {{loops[]}}; Recombine Surface{{s}};
    e[] = Extrude {{0, 0, {2}}} {{ Surface{{s}}; Layers{{1}}; Recombine; }};
    side[] = {{}};
    For i In {{2:9}}
      side[] += {{e[i]}};
    EndFor
    inside[] = Surface In BoundingBox{{-{0} - 1e-6, -{0} - 1e-6, -1, {0} + 1e-6, {0} + 1e-6, {2} + 1}};
    inside[] -= {{known[]}}; known[] += {{s, e[0], side[]}}; side[] -= {{inside[]}};
    Physical Volume("{4}") = {{e[1]}}; Physical Surface("{4}_inner") = {{inside[]}};
    Physical Surface("{4}_outer") = {{side[]}}; Physical Surface("{4}_ends") = {{s, e[0]}};
  )",
                     inner, outer, thickness, around / 4, name);
}

}  // namespace

std::string full_rings_geo(const std::vector<FullRing>& rings, double size, double thickness) {
  std::string geo = fmt::format("SetFactory(\"OpenCASCADE\"); known[] = {{}}; Mesh.MeshSizeMax = {};\n", size);
  for (const FullRing& ring : rings) geo += full_ring(ring.name, ring.inner, ring.outer, ring.around, thickness);
  return geo;
}

std::string rings_geo(const std::vector<RingMesh>& rings, double thickness) {
  std::string geo = "SetFactory(\"OpenCASCADE\"); symmetry_x[] = {}; symmetry_y[] = {};\n";
  for (const RingMesh& ring : rings)
    geo += fmt::format(R"(
      c = newp; Point(c) = {{0, 0, 0}};
      p1 = newp; Point(p1) = {{{1}, 0, 0}}; p2 = newp; Point(p2) = {{{2}, 0, 0}};
      p3 = newp; Point(p3) = {{0, {2}, 0}}; p4 = newp; Point(p4) = {{0, {1}, 0}};
      l1 = newl; Line(l1) = {{p1, p2}}; l2 = newl; Circle(l2) = {{p2, c, p3}};
      l3 = newl; Line(l3) = {{p4, p3}}; l4 = newl; Circle(l4) = {{p1, c, p4}};
      loop = newll; Line Loop(loop) = {{l1, l2, -l3, -l4}}; s = news; Plane Surface(s) = {{loop}};
      Transfinite Curve{{l1, l3}} = {3} + 1 Using Progression {5}; Transfinite Curve{{l2, l4}} = {4} + 1;
      Transfinite Surface{{s}} = {{p1, p2, p3, p4}}; Recombine Surface{{s}};
      out[] = Extrude {{0, 0, {6}}} {{ Surface{{s}}; Layers{{1}}; Recombine; }};
      Physical Volume("{0}") = {{out[1]}};
      Physical Surface("{0}_outer") = {{out[3]}}; Physical Surface("{0}_inner") = {{out[5]}};
      Physical Surface("{0}_low") = {{s}}; Physical Surface("{0}_high") = {{out[0]}};
      symmetry_y[] += {{out[2]}}; symmetry_x[] += {{out[4]}};
    )",
                       ring.name, ring.inner, ring.outer, ring.radial, ring.around, ring.growth, thickness);
  return geo +
         "Physical Surface(\"symmetry_x\") = {symmetry_x[]}; Physical Surface(\"symmetry_y\") = {symmetry_y[]};\n";
}

std::string ring_supports(const std::vector<RingMesh>& rings, bool plane_strain) {
  std::string toml = R"(
    [[supports]]
    on = "symmetry_x"
    displacement = { x = 0 }
    [[supports]]
    on = "symmetry_y"
    displacement = { y = 0 }
  )";
  for (const RingMesh& ring : rings)
    for (const char* end : {"low", "high"})
      if (plane_strain || end == std::string("low"))
        toml += fmt::format("[[supports]]\non = \"{}_{}\"\ndisplacement = {{ z = 0 }}\n", ring.name, end);
  return toml;
}

std::string body(const std::string& name, double young_modulus, double poisson_ratio, double A, double n) {
  std::string toml = fmt::format(
      "[bodies.{0}]\nregion = \"{0}\"\nmaterial = \"{0}\"\n[materials.{0}]\nyoung_modulus = {1}\npoisson_ratio = {2}\n",
      name, young_modulus, poisson_ratio);
  if (A > 0) toml += fmt::format("[[materials.{}.creep]]\nlaw = \"norton\"\nA = {}\nn = {}\n", name, A, n);
  return toml;
}

std::string probe(const std::string& name, const std::string& quantity, const std::string& position) {
  return fmt::format("[[probes]]\nname = \"{}\"\nquantity = \"{}\"\n{}\n", name, quantity, position);
}

}  // namespace creepcontact::test
