#pragma once
/// The part of a contact that a probe looks at.

#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::results {

/// One side of a contact pair, or a part of it. All nodes are shared in proportion to the areas of the faces around
/// them, so that the values of parts add up to that of the whole.
struct ContactPart {
  std::size_t pair = 0;
  std::size_t body = 0;  ///< on this side
  bool is_slave = false;
  std::vector<double> multiplier_shares;  ///< indexed by multiplier node, 0 to 1
  std::vector<char> lies_within;          ///< indexed by multiplier node: whether it counts in extremes
  std::vector<double> node_shares;        ///< indexed by node of the body: share of its contact force, 0 to 1
};

/// The parts of all pairs that the probe's surface and condition select.
/// @throws ModelError if there are none
std::vector<ContactPart> contact_parts(const config::Probe& probe, const model::Model& model);

}  // namespace creepcontact::results
