#pragma once
/// Rotation of the elements of a body, which the theory of small displacements takes as small.

#include <span>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::mechanics {

struct ElementRotation {
  double angle = 0;  ///< radians: length of half the curl of the displacement
  Vector3 position = Vector3::Zero();
};

/// Rotations at the centres of the elements that the discretization of a body has; in sections those in their plane.
/// Immutable. Memory: 8 bytes per element.
class ElementRotations {
 public:
  /// @param body  must outlive the object
  explicit ElementRotations(const Body& body);

  /// The largest rotation above the limit, else 0. @param u  3 n_nodes @param limit  radians
  /// Cost: some ten operations per node of an element, ten times as many in elements that may rotate so far.
  ElementRotation largest(std::span<const double> u, double limit = 0) const;

 private:
  const Body& body_;
  std::vector<double> slopes_;  // sum of |grad N_i| over the nodes of an element
};

}  // namespace creepcontact::mechanics
