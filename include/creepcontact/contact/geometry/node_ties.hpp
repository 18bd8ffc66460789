#pragma once
/// Bodies joined node to node, as a single mesh would join them.

#include <array>
#include <span>
#include <vector>

#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

/// One of the two bodies; pointers must be valid during the call only.
struct TiedBody {
  const mesh::Mesh* mesh = nullptr;
  const mechanics::Constraints* constraints = nullptr;
};

/// Projector on the directions that supports leave free at a node.
Matrix3 free_part(const mechanics::Constraints& constraints, std::int64_t node);

/// Orthonormal axes as columns, each with a mark whether it is free.
struct FreeAxes {
  Matrix3 axes = Matrix3::Identity();
  std::array<bool, 3> is_free{};
};
/// Axes of which some span what is free at one of two nodes at least: x, y and z where this is possible.
/// @param projectors  sum of free_part() of the two nodes
FreeAxes free_axes(const Matrix3& projectors);

/// Rows area * n . (u_master - u_slave) = 0, at most three per tie, for orthonormal directions n in which at least one
/// of the two nodes is free; the rows are then linearly independent whatever supports the nodes have. Unlike in
/// mortar_coupling, each row has its own entry in `nodes` and `area`, with n as its normal.
MortarCoupling node_ties(const TiedBody& slave, const TiedBody& master, std::span<const NodeTie> ties);

}  // namespace creepcontact::contact
