#include "verification/plane_regions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verification/half_space.hpp"

namespace creepcontact::test {
namespace {

std::string transfinite(const std::string& curves, const Extent& along) {
  return fmt::format("Transfinite Curve{{{}}} = {} Using Progression {:.12g};\n", curves, along.divisions + 1,
                     along.growth);
}

}  // namespace

std::string regions_geo(const std::vector<Region>& regions) {
  std::string geo = "SetFactory(\"OpenCASCADE\");\n";
  for (const Region& region : regions) {
    const auto point = [&](double first, double second) {
      const double x = region.polar ? first * std::cos(second) : first;
      const double y = region.polar ? first * std::sin(second) : second;
      return fmt::format("{{{:.15g}, {:.15g}, 0}}", std::abs(x) < 1e-12 * first ? 0 : x, y);
    };
    geo += fmt::format("p = newp; Point(p) = {}; Point(p + 1) = {}; Point(p + 2) = {}; Point(p + 3) = {};\n",
                       point(region.first.from, region.second.from), point(region.first.to, region.second.from),
                       point(region.first.to, region.second.to), point(region.first.from, region.second.to));
    if (region.polar) geo += "c = newp; Point(c) = {0, 0, 0};\n";
    const char* const arc =
        region.polar ? "Circle(l + {}) = {{p + {}, c, p + {}}};\n" : "Line(l + {}) = {{p + {}, p + {}}};\n";
    geo += "l = newl; Line(l) = {p, p + 1}; Line(l + 2) = {p + 3, p + 2};\n";
    geo += fmt::format(fmt::runtime(arc), 1, 1, 2) + fmt::format(fmt::runtime(arc), 3, 0, 3);
    geo += transfinite("l, l + 2", region.first) + transfinite("l + 1, l + 3", region.second);
    geo +=
        "k = newll; Curve Loop(k) = {l, l + 1, -(l + 2), -(l + 3)}; s = news; Plane Surface(s) = {k};\n"
        "Transfinite Surface{s} = {p, p + 1, p + 2, p + 3};\n";
    if (!region.triangles) geo += "Recombine Surface{s};\n";
    geo += fmt::format(
        "Physical Surface(\"{0}\") = {{s}}; Physical Curve(\"{0}_y0\") = {{l}}; Physical Curve(\"{0}_x1\") = {{l + "
        "1}};\n"
        "Physical Curve(\"{0}_y1\") = {{l + 2}}; Physical Curve(\"{0}_x0\") = {{l + 3}};\n",
        region.name);
  }
  return geo;
}

std::string half_plane_geo(const HalfPlane& block) {
  const double h = block.patch / block.fine;
  const double q = growth(h, block.extent - block.patch, block.coarse), qy = growth(h, block.extent, block.deep);
  return fmt::format(R"(
    p = newp; l = newl; k = newll; s = news;
    Point(p) = {{0, 0, 0}}; Point(p + 1) = {{{0}, 0, 0}}; Point(p + 2) = {{{1}, 0, 0}};
    Point(p + 3) = {{0, {2}, 0}}; Point(p + 4) = {{{0}, {2}, 0}}; Point(p + 5) = {{{1}, {2}, 0}};
    Line(l) = {{p, p + 1}}; Line(l + 1) = {{p + 1, p + 2}}; Line(l + 2) = {{p + 3, p + 4}}; Line(l + 3) = {{p + 4, p + 5}};
    Line(l + 4) = {{p, p + 3}}; Line(l + 5) = {{p + 1, p + 4}}; Line(l + 6) = {{p + 2, p + 5}};
    Transfinite Curve{{l, l + 2}} = {3} + 1; Transfinite Curve{{l + 1, l + 3}} = {4} + 1 Using Progression {5:.12g};
    Transfinite Curve{{l + 4, l + 5, l + 6}} = {6} + 1 Using Progression {7:.12g};
    Curve Loop(k) = {{l, l + 5, -(l + 2), -(l + 4)}}; Plane Surface(s) = {{k}};
    Curve Loop(k + 1) = {{l + 1, l + 6, -(l + 3), -(l + 5)}}; Plane Surface(s + 1) = {{k + 1}};
    Transfinite Surface{{s, s + 1}}; Recombine Surface{{s, s + 1}};
    Physical Surface("{8}") = {{s, s + 1}}; Physical Curve("{8}_patch") = {{l}};
    Physical Curve("{8}_far") = {{l + 2, l + 3}}; Physical Curve("{8}_x0") = {{l + 4}};
  )",
                     block.patch, block.extent, block.direction * block.extent, block.fine, block.coarse, q, block.deep,
                     qy, block.name);
}

std::string section_of(const std::string& analysis, int order) {
  return fmt::format("analysis = \"{}\"\n[mesh]\nfile = \"case.geo\"\norder = {}\n", analysis, order);
}

}  // namespace creepcontact::test
