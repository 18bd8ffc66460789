#pragma once
/// *RIGID BODY and *COUPLING: nodes that move as a rigid body, and surfaces whose mean motion follows a node.

#include <optional>
#include <string>
#include <vector>

#include "loading.hpp"

namespace creepcontact::deck {

struct RigidGroup {
  Numbers nodes;
  std::string surface = {};  ///< of a distributing coupling, in upper case; empty: the nodes move as a rigid body
  std::string card = "RIGID BODY";
  std::int64_t reference = 0;            ///< its position is the origin
  std::optional<std::int64_t> rotation;  ///< node whose displacements are the rotations; else 4 to 6 of the reference
  Place place;
};

/// @param impossible  gets sets and nodes that do not exist
std::vector<RigidGroup> find_rigid_groups(const Deck& deck, const Resolver& resolver, std::vector<Note>& impossible);

}  // namespace creepcontact::deck
