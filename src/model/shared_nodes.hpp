#pragma once
/// Bodies that share nodes of the mesh: each has nodes of its own there, which only a contact, or ties node to node,
/// hold together.

#include <vector>

#include "creepcontact/mesh/shared_nodes.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

/// The bodies on the two sides of a contact, in the order of its surfaces. A surface that is meshed once between two
/// bodies is on both: each side takes another of them.
/// @param owners  bodies that have the two surfaces, none empty
/// @throws ModelError if there is but one body
std::array<std::size_t, 2> contact_bodies(const config::Contact& contact, const config::Config& config,
                                          const std::array<std::vector<std::size_t>, 2>& owners);

class SharedNodes {
 public:
  /// @param shared  of the bodies' meshes
  /// @throws ModelError if the surfaces of a contact are missing, as check_groups
  SharedNodes(const config::Config& config, const mesh::Mesh& whole, const BodyMeshes& meshes, mesh::SharedMesh shared);

  /// Finds bodies that would come apart: those that share faces whose nodes no contact covers, unless
  /// mesh.share_nodes = "tie", and those that share nodes along an edge or at a point only.
  void check(const config::Config& config, ErrorCollector& errors) const;
  /// Nodes that no contact keeps apart, as ties() joins them.
  struct Joined {
    mesh::SharedNode::Owner first, second;
    double area = 0;
  };
  std::vector<Joined> joined() const;
  /// Pairs without surfaces that tie what no contact covers. Every node's bodies are joined in a chain, so that no tie
  /// depends on others. @throws ModelError if supports move tied nodes apart
  std::vector<contact::Pair> ties(const config::Config& config, const Bodies& bodies) const;

 private:
  struct Link {
    std::size_t first = 0, second = 0;  // bodies, ascending
    double area = 0;                    // of the faces around the node that the two share
    bool covered = false;               // by a contact
  };
  void link_faces();
  void cover(const config::Contact& contact, const config::Config& config, const mesh::Mesh& whole,
             const BodyMeshes& meshes);
  std::size_t n_shared(std::size_t first, std::size_t second) const;

  mesh::SharedMesh shared_;
  std::vector<std::vector<Link>> links_;  // of each node
};

}  // namespace creepcontact::model
