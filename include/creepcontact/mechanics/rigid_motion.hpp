#pragma once
/// Rigid-body modes, and those that supports leave free for a set of nodes.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "creepcontact/mechanics/constraints.hpp"

namespace creepcontact::mechanics {

/// A small rigid-body motion: translation, rotation about an axis, or both.
struct RigidMotion {
  Vector3 translation = Vector3::Zero();  ///< of the point `centre`
  Vector3 rotation = Vector3::Zero();     ///< rotation vector [rad] about `centre`
  Vector3 centre = Vector3::Zero();
  /// Text for messages: "translation along z", "rotation about the axis (0, 0, 1) through (0, 0, 5)".
  std::string describe() const;
  /// Sum of motions, relative to the centre of the first. @param amplitudes  one per motion
  static RigidMotion combination(const std::vector<RigidMotion>& motions, const Eigen::VectorXd& amplitudes);
  /// This motion, possibly reversed, simplified for display: parts that move a body of this size by less than 1e-4
  /// of the whole are left out.
  RigidMotion tidied(double size) const;
  /// Displacement of a point.
  Vector3 displacement(const Vector3& x) const;
};

/// Basis of the free rigid-body motions; empty if the supports hold the body. Consists of translations and rotations
/// about coordinate directions if such a basis exists.
/// In axisymmetric sections the hoop strain resists all motions across the axis.
/// @param subset  nodes that move together
std::vector<RigidMotion> free_rigid_motions(const mesh::Mesh& mesh, const Constraints& constraints,
                                            const std::vector<std::int64_t>& subset);
/// The six rigid-body motions of all nodes on the free dofs, n_free x 6: of the body without its supports, whose nodes
/// stay where they hold them (the nearest motion that supports and links allow). Cost: O(n_nodes).
Eigen::MatrixXd rigid_motions_on_free(const std::vector<Vector3>& nodes, const Constraints& constraints);
/// Directions in which something resists the rigid-body modes at a node: those held, and the radius of axisymmetric
/// sections.
std::vector<Vector3> resisted_directions(const mesh::Mesh& mesh, const Constraints& constraints, std::int64_t node);

}  // namespace creepcontact::mechanics
