#pragma once
/// The null space of a body's stiffness: motions without strain that no support prevents. Usually the whole body moves
/// as one; a mesh in several pieces, or pieces joined at an edge or a node only, has motions of its parts.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/mechanics/rigid_motion.hpp"

namespace creepcontact::mechanics {

struct FreeMotion {
  Eigen::VectorXd displacement;      ///< 3 n_nodes; the largest of a node is 1
  std::optional<RigidMotion> rigid;  ///< the same, if all of the body moves as one
  std::string description;           ///< "translation along z"; of a part: with its place
};

/// Nodes, ascending, of every piece of the mesh that can only move as a rigid whole: elements joined by faces. Parts
/// may share nodes (hinges). Cost: O(n_elements log n_elements).
using MeshParts = std::vector<std::vector<std::int64_t>>;
MeshParts mesh_parts(const mesh::Mesh& mesh);

/// Basis of the null space; empty for a body that is held.
/// Cost: O(n_nodes), and (6 n_parts)^3 for parts that share nodes.
std::vector<FreeMotion> free_motions(const mesh::Mesh& mesh, const MeshParts& parts, const Constraints& constraints);

/// Free unknowns, one a motion, that hold the body in a statically determinate way when they are fixed: those that the
/// motions move most, one after the other (pivoted QR).
std::vector<std::int64_t> determinate_pins(const std::vector<FreeMotion>& motions, const Constraints& constraints);

}  // namespace creepcontact::mechanics
