#pragma once
/// A cube of 100 mm of one element in a uniform state, its material given as text.

#include <string>

#include "verification/boxes.hpp"
#include "verification/case.hpp"

namespace creepcontact::test {

inline const char* const cube_geo = R"(
  Point(1) = {0, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {100, 100, 0}; Point(4) = {0, 100, 0};
  Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
  Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
  Transfinite Curve{1, 2, 3, 4} = 2; Transfinite Surface{1}; Recombine Surface{1};
  out[] = Extrude {0, 0, 100} { Surface{1}; Layers{1}; Recombine; };
  Physical Volume("cube") = {out[1]};
  Physical Surface("z0") = {1}; Physical Surface("z1") = {out[0]};
  Physical Surface("y0") = {out[2]}; Physical Surface("x1") = {out[3]};
  Physical Surface("y1") = {out[4]}; Physical Surface("x0") = {out[5]};
)";

/// E = 200e3, nu = 0.3; probes of stress and creep strain, sxx, cxx, ..., damage and life.
/// @param material  further tables of the material "steel"
/// @param loading   supports and loads besides the symmetry planes, temperature, contacts
/// @param time      keys of [time]
std::string cube_toml(const std::string& material, const std::string& loading, const std::string& time);

Outcome run_cube(const std::string& material, const std::string& loading, const std::string& time);

/// Uniaxial stress along x as a function value (TOML).
std::string pulled(const std::string& stress);
/// One mechanism of "steel".
std::string creep_law_table(const std::string& law, const std::string& keys);

}  // namespace creepcontact::test
