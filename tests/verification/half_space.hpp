#pragma once
/// Geometry of a quarter (or half) of a large block with a fine patch of its surface around the origin, as much of a
/// half space as the elements allow: the size of the elements grows geometrically away from the patch.

#include <string>

namespace creepcontact::test {

struct HalfSpace {
  std::string name;
  double surface;     ///< z of its surface
  double direction;   ///< -1: the body lies below its surface, 1: above
  double patch;       ///< the patch is 0 < x < patch (and 0 < y < patch)
  int fine;           ///< elements along the patch
  double extent;      ///< of the block, in all directions
  int coarse;         ///< elements from the end of the patch to that of the block
  int deep;           ///< elements over the depth
  double width = 0;   ///< > 0: a slice 0 < y < width, one element wide
  bool half = false;  ///< both sides of x = 0 instead of a quarter
};

/// Ratio of a geometric series of n terms with this first term and this sum.
double growth(double first, double sum, int n);

/// Groups: volume <name>; surfaces <name>_patch, <name>_far (the end of its depth), <name>_front, <name>_back (the
/// sides y = 0 and largest y of a slice), <name>_x0 (of a quarter), <name>_y0 (symmetry).
std::string half_space_geo(const HalfSpace& block);

/// Supports: symmetry planes; sides of a slice held (plane strain); far end displaced by `z`.
std::string half_space_supports(const HalfSpace& block, double z);

}  // namespace creepcontact::test
