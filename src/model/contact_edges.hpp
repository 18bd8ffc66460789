#pragma once
/// How many elements lie between the edges of a contact surface at which pressure concentrates.

#include <optional>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::model {

/// Rows of nodes from the edges of a surface to its middle, 1 on a surface that is one element wide, 2 on one of two or
/// three. An edge counts where the other surface goes on beyond it: a border that supports or cyclic symmetry hold
/// across, and one at which both surfaces end, has no peak of pressure.
/// @returns nullopt if there is no such edge
std::optional<int> rows_between_edges(const mechanics::Body& body, const std::string& surface,
                                      const mechanics::Body& other, const std::string& other_surface);

}  // namespace creepcontact::model
