#pragma once
/// Bodies joined node to node, as a single mesh would join them.

#include <span>
#include <vector>

#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

/// Two nodes at the same position that move together.
struct NodeTie {
  std::int64_t slave = 0, master = 0;
  double area = 0;  ///< > 0, of the surface around the node; converts the multiplier to a pressure
};

/// One of the two bodies; pointers must be valid during the call only.
struct TiedBody {
  const mesh::Mesh* mesh = nullptr;
  const mechanics::Constraints* constraints = nullptr;
};

/// Rows area * n . (u_master - u_slave) = 0, at most three per tie, for orthonormal directions n in which at least one
/// of the two nodes is free; the rows are then linearly independent whatever supports the nodes have. Unlike in
/// mortar_coupling, each row has its own entry in `nodes` and `area`, with n as its normal.
MortarCoupling node_ties(const TiedBody& slave, const TiedBody& master, std::span<const NodeTie> ties);

}  // namespace creepcontact::contact
