#pragma once
/// Rigid motions, and those of a set of nodes that supports leave free.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::mechanics {

/// A motion that the supports leave free: translation, or rotation about an axis.
struct RigidMotion {
  Vector3 translation = Vector3::Zero();  ///< of the point `centre`
  Vector3 rotation = Vector3::Zero();
  Vector3 centre = Vector3::Zero();
  /// "translation along z", "rotation about the axis (0, 0, 1) through (0, 0, 5)"
  std::string describe() const;
  /// The sum of motions, about this one's centre. @param amplitudes  one a motion
  static RigidMotion combination(const std::vector<RigidMotion>& motions, const Eigen::VectorXd& amplitudes);
  /// The same motion, forwards or backwards, for a reader: without parts that move a body of this size by less than
  /// 1e-4 of the whole.
  RigidMotion tidied(double size) const;
  /// Displacement of a point.
  Vector3 displacement(const Vector3& x) const;
};

/// Basis of the free rigid-body motions: empty for a body that is held. Prefers pure translations and rotations about
/// coordinate directions where such a basis exists, so that it reads well.
/// @param subset  nodes that move together
std::vector<RigidMotion> free_rigid_motions(const std::vector<Vector3>& nodes, const Constraints& constraints,
                                            const std::vector<std::int64_t>& subset);

}  // namespace creepcontact::mechanics
