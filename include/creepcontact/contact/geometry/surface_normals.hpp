#pragma once
/// Smooth normals of a faceted surface, and the multiplier nodes on it.

#include <vector>

#include "creepcontact/contact/geometry/facet.hpp"
#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::contact {

/// Position and normal of one multiplier: a corner node, or one side of a crease at it. Faces that meet at more than 40
/// degrees have separate multipliers and normals.
struct MultiplierNode {
  std::int64_t node = 0;
  Vector3 normal;
};

/// Second-order accurate nodal normals: means of the normals of the adjacent smooth faces with Max's weights. At open
/// edges of linear faces they are completed from the neighbours (open_edge_normals.hpp). At supported nodes they are
/// turned into the planes of symmetry that the held directions imply; otherwise the pressure at such edges would be
/// wrong by 3-7 %. Exact on planes and spheres, and on cylinders divided along their axis.
/// Source: N. Max, Weights for computing vertex normals from facet normals, J. Graphics Tools 4 (1999).
struct SurfaceNormals {
  std::vector<MultiplierNode> multipliers;
  std::vector<std::vector<int>> multiplier_of_corner;  ///< [facet][corner]: index into multipliers
  std::vector<std::vector<Vector3>> normal_of_node;    ///< [facet][node]
};

/// @param constraints  of the body that the facets belong to
SurfaceNormals surface_normals(const std::vector<Facet>& facets, const mechanics::Constraints& constraints);

}  // namespace creepcontact::contact
