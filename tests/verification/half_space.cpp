#include "verification/half_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace creepcontact::test {

double growth(double first, double sum, int n) {
  double low = 1 + 1e-9, high = 10;
  while (high - low > 1e-12) {
    const double q = (low + high) / 2;
    (first * (std::pow(q, n) - 1) / (q - 1) < sum ? low : high) = q;
  }
  return low;
}

std::string half_space_geo(const HalfSpace& block) {
  const double h = block.patch / block.fine;
  const double q = growth(h, block.extent - block.patch, block.coarse);
  const double qz = growth(h, block.extent, block.deep);
  const bool slice = block.width > 0;
  std::string geo = fmt::format("X[] = {{{2}, {0}, {1}}};\n", block.patch, block.extent,
                                block.half ? fmt::format("{}, {}", -block.extent, -block.patch) : "0");
  geo += slice ? fmt::format("Y[] = {{0, {}}};\n", block.width)
               : fmt::format("Y[] = {{0, {}, {}}};\n", block.patch, block.extent);
  const int rows = slice ? 1 : 2, columns = block.half ? 3 : 2;
  const auto lines = [&](int i, bool along_y) {
    // Intervals: 0 the patch, 1 from there to the end; the width of a slice is one element.
    if (along_y && slice) return std::string(" = 2");
    if (!along_y && block.half) {
      if (i == 0) return fmt::format(" = {} Using Progression {:.12g}", block.coarse + 1, 1 / q);
      if (--i == 0) return fmt::format(" = {}", 2 * block.fine + 1);
    }
    return i == 0 ? fmt::format(" = {}", block.fine + 1)
                  : fmt::format(" = {} Using Progression {:.12g}", block.coarse + 1, q);
  };
  geo += "p = newp; l = newl; s = news;\n";
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      geo += fmt::format("Point(p + {}) = {{X[{}], Y[{}], {}}};\n", 4 * j + i, i, j, block.surface);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < columns; ++i)
      geo += fmt::format("Line(l + {0}) = {{p + {1}, p + {2}}}; Transfinite Curve{{l + {0}}}{3};\n", 10 * j + i,
                         4 * j + i, 4 * j + i + 1, lines(i, false));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i <= columns; ++i)
      geo += fmt::format("Line(l + {0}) = {{p + {1}, p + {2}}}; Transfinite Curve{{l + {0}}}{3};\n", 50 + 10 * j + i,
                         4 * j + i, 4 * j + i + 4, lines(j, true));
  std::string all;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int k = columns * j + i;
      geo += fmt::format(
          "Line Loop(l + {0}) = {{l + {1}, l + {2}, -(l + {3}), -(l + {4})}}; Plane Surface(s + {5}) = {{l + {0}}};\n"
          "Transfinite Surface{{s + {5}}}; Recombine Surface{{s + {5}}};\n",
          200 + k, 10 * j + i, 50 + 10 * j + i + 1, 10 * j + 10 + i, 50 + 10 * j + i, k);
      all += fmt::format("{}s + {}", all.empty() ? "" : ", ", k);
    }
  std::string numbers, depths;
  double depth = 0;
  for (int k = 0; k < block.deep; ++k) {
    depth += h * std::pow(qz, k) / block.extent;
    numbers += k == 0 ? "1" : ", 1";
    depths += fmt::format("{}{:.12g}", k == 0 ? "" : ", ", k + 1 == block.deep ? 1.0 : depth);
  }
  geo += fmt::format("out[] = Extrude {{0, 0, {}}} {{ Surface{{{}}}; Layers{{{{{}}}, {{{}}}}}; Recombine; }};\n",
                     block.direction * block.extent, all, numbers, depths);
  const double z0 = std::min(block.surface, block.surface + block.direction * block.extent);
  const double z1 = z0 + block.extent, y1 = slice ? block.width : block.extent, e = 1e-6 * block.patch;
  const auto side = [&](const char* group, double xa, double xb, double ya, double yb, double za, double zb) {
    geo += fmt::format("Physical Surface(\"{}_{}\") = Surface In BoundingBox{{{}, {}, {}, {}, {}, {}}};\n", block.name,
                       group, xa - e, ya - e, za - e, xb + e, yb + e, zb + e);
  };
  const double x0 = block.half ? -block.extent : 0;
  geo += fmt::format("Physical Volume(\"{}\") = Volume In BoundingBox{{{}, {}, {}, {}, {}, {}}};\n", block.name, x0 - e,
                     -e, z0 - e, block.extent + e, y1 + e, z1 + e);
  const double far = block.surface + block.direction * block.extent;
  geo += fmt::format("Physical Surface(\"{}_patch\") = {{s + {}}};\n", block.name, columns - 2);
  side("far", x0, block.extent, 0, y1, far, far);
  if (!block.half) side("x0", 0, 0, 0, y1, z0, z1);
  side("y0", x0, block.extent, 0, 0, z0, z1);
  if (slice) side("back", 0, block.extent, y1, y1, z0, z1);
  return geo;
}

std::string half_space_supports(const HalfSpace& block, double z) {
  const auto support = [&](const char* group, const char* component, double value) {
    return fmt::format("[[supports]]\non = \"{}_{}\"\ndisplacement = {{ {} = {} }}\n", block.name, group, component,
                       value);
  };
  return (block.half ? "" : support("x0", "x", 0)) + support("y0", "y", 0) +
         (block.width > 0 ? support("back", "y", 0) : "") + support("far", "z", z);
}

}  // namespace creepcontact::test
