#pragma once
/// Bodies joined node to node, as one mesh would join them.

#include <span>
#include <vector>

#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

/// Two nodes at one place that are to move alike.
struct NodeTie {
  std::int64_t slave = 0, master = 0;
  double area = 0;  ///< > 0, of the surface around the node: makes a pressure of its multiplier
};

/// One of the two bodies.
struct TiedBody {
  const mesh::Mesh* mesh = nullptr;
  const mechanics::Constraints* constraints = nullptr;
};

/// Rows area * n . (u_master - u_slave) = 0 for the directions n in which one of the two nodes at least is free: at
/// most three of each tie, orthonormal, so that supports of both nodes make no row depend on others. Unlike the rows of
/// mortar_coupling, every row is an entry of its own in `nodes` and `area`, with n for its normal.
MortarCoupling node_ties(const TiedBody& slave, const TiedBody& master, std::span<const NodeTie> ties);

}  // namespace creepcontact::contact
