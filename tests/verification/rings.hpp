#pragma once
/// Geometry and configuration text for rings: a quarter of a slice of one or two concentric cylinders.

#include <string>
#include <vector>

namespace creepcontact::test {

struct RingMesh {
  std::string name;
  double inner, outer;
  int radial, around;
  double growth = 1.0;  ///< of the elements outwards
};

/// Groups: volume <name>, surfaces <name>_inner, <name>_outer, <name>_low, <name>_high (z), symmetry_x, symmetry_y of
/// all.
std::string rings_geo(const std::vector<RingMesh>& rings, double thickness);

struct FullRing {
  std::string name;
  double inner, outer;
  int around;  ///< faces on each circle, a multiple of 4
};

/// Slices one element thick, unstructured across. Groups: volume <name>, surfaces <name>_inner, <name>_outer,
/// <name>_ends. @param size  largest size of an element
std::string full_rings_geo(const std::vector<FullRing>& rings, double size, double thickness);

/// Symmetry supports, and for plane strain the ends held.
std::string ring_supports(const std::vector<RingMesh>& rings, bool plane_strain);

std::string body(const std::string& name, double young_modulus, double poisson_ratio, double A = 0, double n = 1);

std::string probe(const std::string& name, const std::string& quantity, const std::string& position);

}  // namespace creepcontact::test
