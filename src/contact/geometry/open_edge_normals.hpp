#pragma once
/// Normals at the open edges of a surface of linear faces, where faces lie on one side of a node only and their mean is
/// wrong to first order.

#include "creepcontact/contact/geometry/surface_normals.hpp"
#include "symmetry.hpp"

namespace creepcontact::contact {

/// On spheres and cylinders the normals at both ends of any chord make the same angle with it, elsewhere to second
/// order:  (n_i + n_j) . (x_j - x_i) = 0. These conditions, to nodes of the same faces whose normal is known, correct
/// the normals of nodes on open edges: first from the inner nodes, then the corners from the edges. Edges that lie in a
/// plane of symmetry are not open. Nodes without such a neighbour keep
/// their normals; nodes next to a kink do not count as neighbours.
void correct_open_edges(const std::vector<Facet>& facets, const SymmetryPlanes& symmetry, SurfaceNormals& normals);

}  // namespace creepcontact::contact
