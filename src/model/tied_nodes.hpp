#pragma once
/// Nodes of two bodies that are tied to each other, in contacts or by mesh.share_nodes = "tie".

#include <span>
#include <vector>

#include "creepcontact/contact/geometry/node_ties.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

/// Displacements that supports prescribe along a direction for both nodes of a tie must be the same.
/// @param times  at which they are compared @throws ModelError naming the first node where they are not
void require_same_supports(std::span<const contact::NodeTie> ties, const mechanics::Body& slave,
                           const mechanics::Body& master, std::span<const double> times);

/// Empties the rows of ties that follow from others, as where three bodies meet at an edge, or from links between
/// nodes; their multipliers would be undetermined. @throws ModelError if supports contradict such a row Cost: sparse QR
/// of the rows that could depend on each other: those that have no displacement of their own.
void leave_out_dependent_ties(const Bodies& bodies, std::span<const double> times, std::vector<contact::Pair>& pairs);

}  // namespace creepcontact::model
