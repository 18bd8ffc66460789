#include "verification/boxes.hpp"

#include <fmt/format.h>

namespace creepcontact::test {

std::string boxes_geo(const std::vector<Box>& boxes) {
  std::string geo = "SetFactory(\"OpenCASCADE\");\n";
  for (const Box& box : boxes) {
    const double x0 = box.origin[0], x1 = x0 + box.lengths[0], y0 = box.origin[1], y1 = y0 + box.lengths[1];
    const double z = box.origin[2];
    geo += fmt::format(
        "p1 = newp; Point(p1) = {{{0}, {2}, {4}}}; p2 = newp; Point(p2) = {{{1}, {2}, {4}}};\n"
        "p3 = newp; Point(p3) = {{{1}, {3}, {4}}}; p4 = newp; Point(p4) = {{{0}, {3}, {4}}};\n",
        x0, x1, y0, y1, z);
    geo += fmt::format(
        "l1 = newl; Line(l1) = {{p1, p2}}; l2 = newl; Line(l2) = {{p2, p3}};\n"
        "l3 = newl; Line(l3) = {{p3, p4}}; l4 = newl; Line(l4) = {{p4, p1}};\n"
        "Transfinite Curve{{l1, l3}} = {} + 1; Transfinite Curve{{l2, l4}} = {} + 1;\n"
        "loop = newll; Line Loop(loop) = {{l1, l2, l3, l4}}; s = news; Plane Surface(s) = {{loop}};\n"
        "Transfinite Surface{{s}};\n",
        box.divisions[0], box.divisions[1]);
    // Two halves on top of each other, so that the middle is a surface.
    const std::string layers = fmt::format("Layers{{{}}}; {}", box.divisions[2] / 2, box.hexahedra ? "Recombine;" : "");
    geo += box.hexahedra ? "Recombine Surface{s};\n" : "";
    geo += fmt::format(
        "low[] = Extrude {{0, 0, {0}}} {{ Surface{{s}}; {1} }}; up[] = Extrude {{0, 0, {0}}} {{ Surface{{low[0]}}; {1} "
        "}};\n",
        box.lengths[2] / 2, layers);
    geo += fmt::format(
        "Physical Volume(\"{0}\") = {{low[1], up[1]}}; Physical Surface(\"{0}_z0\") = {{s}};\n"
        "Physical Surface(\"{0}_z1\") = {{up[0]}}; Physical Surface(\"{0}_middle\") = {{low[0]}};\n",
        box.name);
    const char* const sides[] = {"y0", "x1", "y1", "x0"};
    for (int i = 0; i < 4; ++i)
      geo += fmt::format("Physical Surface(\"{0}_{1}\") = {{low[{2}], up[{2}]}};\n", box.name, sides[i], i + 2);
  }
  return geo;
}

std::string support(const std::string& surface, const std::string& component, const std::string& value) {
  return fmt::format("[[supports]]\non = \"{}\"\ndisplacement = {{ {} = {} }}\n", surface, component, value);
}

std::string contact_table(const std::string& first, const std::string& second, const std::string& more) {
  return fmt::format("[[contacts]]\nname = \"{0}/{1}\"\nbetween = [\"{0}\", \"{1}\"]\n{2}\n", first, second, more);
}

}  // namespace creepcontact::test
