#pragma once
/// Which multiplier nodes of a pair are in contact.

#include <vector>

#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// True if the normal row of a multiplier node is active in the solution. This, and not the sign of its multiplier,
/// says that a node is in contact: iterations leave rounding errors of either sign in multipliers that are zero.
/// @param pair  numbered @param node  of the pair
bool is_closed(const Pair& pair, std::size_t node, const ContactState& state);

/// is_closed() for all multiplier nodes of the pair: 1 or 0 each.
std::vector<char> closed_nodes(const Pair& pair, const ContactState& state);

}  // namespace creepcontact::contact
