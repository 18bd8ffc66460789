#pragma once
/// Smooth normals of a surface, and the multiplier nodes on it.

#include <vector>

#include "creepcontact/contact/geometry/facet.hpp"
#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::contact {

/// Where one multiplier lives: a corner node, or one side of a crease at it (faces that meet at more than 40 degrees
/// get multipliers and normals of their own).
struct MultiplierNode {
  std::int64_t node = 0;
  Vector3 normal;
};

/// Nodal normals of second order: means of the adjacent smooth faces' normals with Max's weights, at open edges of
/// linear faces completed by their neighbours (open_edge_normals.hpp), and laid into the planes of symmetry that the
/// supports make of a node's held directions (without it the pressure is 3-7 % wrong at such edges). Exact on planes
/// and spheres, and on cylinders divided along their axis. Source: N. Max, Weights for computing vertex normals from
/// facet normals, J. Graphics Tools 4 (1999).
struct SurfaceNormals {
  std::vector<MultiplierNode> multipliers;
  std::vector<std::vector<int>> multiplier_of_corner;  ///< [facet][corner] -> index into multipliers
  std::vector<std::vector<Vector3>> normal_of_node;    ///< [facet][node]
};

SurfaceNormals surface_normals(const std::vector<Facet>& facets, const mechanics::Constraints& constraints);

}  // namespace creepcontact::contact
