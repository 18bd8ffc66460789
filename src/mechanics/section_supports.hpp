#pragma once
/// What holds the nodes of a section without supports of the user.

#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::mechanics {

/// The supports, and before them those of the section: no displacement out of its plane, nor across the axis of
/// rotation at nodes on it, and none but the axial strain at the axial node. A solid has none of its own.
std::vector<Support> with_section_supports(const mesh::Mesh& mesh, const std::vector<Support>& supports);

}  // namespace creepcontact::mechanics
