#pragma once
// The unit cube as .geo in every kind of cell.

#include <string>

namespace creepcontact::io::test {

/// @param cells "hex", "wedge" or "tet"; n divisions an edge by the constant n
inline std::string cube_geo(const std::string& cells) {
  const std::string base = R"(
DefineConstant[ n = 2 ];
DefineConstant[ height = {1, Min 0.1, Max 9, Name "Parameters/height"} ];
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1:4} = n + 1;
Transfinite Surface{1};
)";
  const std::string groups = R"(
Physical Volume("cube") = {out[1]};
Physical Surface("bottom") = {1};
Physical Surface("top") = {out[0]};
Physical Surface("sides") = {out[2], out[3], out[4], out[5]};
Physical Curve("edge") = {1};
Physical Point("corner") = {1};
Physical Surface(77) = {1};
)";
  const std::string recombine = cells == "hex" ? "Recombine Surface{1};\n" : "";
  const std::string layers = cells == "tet" ? "" : " Layers{n}; Recombine;";
  return base + recombine + "out[] = Extrude {0, 0, height} { Surface{1};" + layers + " };\n" + groups;
}

}  // namespace creepcontact::io::test
