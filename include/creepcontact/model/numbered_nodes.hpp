#pragma once
/// Nodes of bodies by their numbers in the mesh file.

#include <span>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::model {

struct NodeOfBody {
  std::size_t body = 0;
  std::int64_t node = 0;
};

/// The bodies that have the node; several where they share it. Cost: a search per body.
std::vector<NodeOfBody> nodes_numbered(std::span<const mechanics::Body> bodies, std::int64_t number);

}  // namespace creepcontact::model
