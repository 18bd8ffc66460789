#pragma once
/// Geometry and configuration text for plane and axisymmetric sections.

#include <array>
#include <string>
#include <vector>

namespace creepcontact::test {

/// How far a region extends along one of its two directions, in elements whose length grows geometrically.
struct Extent {
  double from, to;
  int divisions;
  double growth = 1;
};

/// A rectangle x, y; or a part of a ring: the radius and the angle [rad] from the x axis.
struct Region {
  std::string name;
  Extent first, second;
  bool polar = false;
  bool triangles = false;  ///< else quadrilaterals
};

/// Groups: surfaces <name>; curves <name>_x0, <name>_x1 (least and largest x or radius), <name>_y0, <name>_y1.
std::string regions_geo(const std::vector<Region>& regions);

/// The end of a half plane: a region along x from the origin with `fine` elements up to `patch`, growing beyond it, and
/// depth along y. Groups as of a region <name>; curve <name>_patch instead of the part of the surface up to `patch`.
struct HalfPlane {
  std::string name;
  double direction;  ///< -1: the body lies below y = 0, 1: above
  double patch;
  int fine;
  double extent;
  int coarse, deep;
};
std::string half_plane_geo(const HalfPlane& block);

/// [mesh] and `analysis` for the geometry of a case.
std::string section_of(const std::string& analysis, int order = 2);

}  // namespace creepcontact::test
