#pragma once
/// The null space of the stiffness of a body: motions without strain that no support prevents. Usually the whole body
/// moves as one; if a mesh has several pieces, or pieces joined only at an edge or a node, its parts move separately.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/mechanics/rigid_motion.hpp"

namespace creepcontact::mechanics {

/// One motion of the null space, with unit amplitude.
struct FreeMotion {
  Eigen::VectorXd displacement;      ///< 3 n_nodes; the largest nodal displacement is 1
  std::optional<RigidMotion> rigid;  ///< the same, if the whole body moves rigidly
  std::string description;           ///< "translation along z"; of a part: with its position
};

/// Nodes, ascending, of each piece of the mesh that can only move rigidly: elements joined by faces. Pieces may share
/// nodes (hinges). Cost: O(n_elements log n_elements).
using MeshParts = std::vector<std::vector<std::int64_t>>;
MeshParts mesh_parts(const mesh::Mesh& mesh);

/// Basis of the null space; empty if the supports hold the body.
/// Cost: O(n_nodes), plus (6 n_parts)^3 if parts share nodes.
std::vector<FreeMotion> free_motions(const mesh::Mesh& mesh, const MeshParts& parts, const Constraints& constraints);

/// Fixing dofs: free dofs, one per motion, that hold the body in a statically determinate way when they are fixed.
/// Chosen one after the other as those that the motions move most (pivoted QR).
std::vector<std::int64_t> determinate_fixing_dofs(const std::vector<FreeMotion>& motions,
                                                  const Constraints& constraints);

}  // namespace creepcontact::mechanics
