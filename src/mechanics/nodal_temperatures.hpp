#pragma once
/// Temperatures that are given at the nodes of a mesh, interpolated by the shape functions of its elements.

#include <span>
#include <vector>

#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"
#include "creepcontact/mesh/mesh.hpp"
#include "creepcontact/mesh/point_tree.hpp"
#include "scattered_interpolation.hpp"

namespace creepcontact::mechanics {

/// The value at a place or node, from those at points.
using PointWeights = std::vector<PointWeight>;

/// Which points are the nodes of the bulk elements of a mesh.
struct NodesAmongPoints {
  NodeCover cover;
  /// Per node; empty of other nodes and of corners without a point. A mid-side node without a point has the mean of the
  /// ends of its edge, which makes the temperature in its element that of the corners.
  std::vector<PointWeights> at_nodes;
};

/// @param tolerance  distance within which a point is a node
NodesAmongPoints nodes_among_points(const mesh::PointTree& points, const mesh::Mesh& mesh, double tolerance);

/// Temperatures at the integration points: sum of shape functions x values at the nodes. Precondition: all nodes have
/// values
std::vector<PointWeights> by_shape_functions(const Discretization& discretization, const mesh::Section& section,
                                             std::span<const PointWeights> at_nodes);

}  // namespace creepcontact::mechanics
