#pragma once
/// Rotation of the elements of a body, which the theory of small displacements takes as small.

#include <span>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::mechanics {

struct ElementRotation {
  double angle = 0;  ///< radians: length of half the curl of the displacement
  Vector3 position = Vector3::Zero();
};

/// The largest rotation at the centres of the elements that the discretization of the body has; 0 if it has none. In
/// sections the rotation is the one in their plane. @param u  3 n_nodes
/// Cost: some hundred operations per element.
ElementRotation largest_rotation(const Body& body, std::span<const double> u);

}  // namespace creepcontact::mechanics
