#pragma once
/// The surface of a sector, continued by those of the adjacent sectors.

#include <Eigen/SparseCore>
#include <map>
#include <optional>

#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

/// Faces and nodes of the surface itself come first, with their own numbers; a surface without a sector ends there.
/// Nodes that cyclic symmetry links are one node where two sectors meet.
class ContinuedSurface {
 public:
  /// @param surface  must outlive the object
  explicit ContinuedSurface(const Surface& surface);

  const mesh::Mesh& mesh() const { return continued_ ? continued_->mesh : *own_.mesh; }
  const std::vector<mesh::Face>& faces() const { return continued_ ? continued_->faces : own_.faces; }
  const mechanics::Constraints& constraints() const {
    return continued_ ? *continued_->constraints : *own_.constraints;
  }
  std::size_t n_own_faces() const { return own_.faces.size(); }
  /// Rows on the displacements of all nodes as rows on those of the own ones.
  RowMatrix on_own_nodes(const RowMatrix& rows) const;
  /// The node of this sector that a node is an image of, and the rotation from there to it.
  std::pair<std::int64_t, Matrix3> own_node(std::int64_t node) const;
  /// How an own node follows another one by cyclic symmetry; nullptr if it does not.
  const mechanics::NodeLinks::Turned* link_or_null(std::int64_t node) const;

 private:
  struct Node {
    std::int64_t own = 0;  // node of the sector that it is an image of
    int turns = 0;         // of the sector to it
  };
  struct Continued {
    mesh::Mesh mesh;  // nodes and section alone
    std::vector<Node> nodes;
    std::vector<mesh::Face> faces;
    std::optional<mechanics::Constraints> constraints;
  };
  void add_sector(int turns);
  /// Its number, which is added if there is none.
  std::int64_t number(Node node);

  const Surface& own_;
  std::optional<Continued> continued_;
  std::map<std::int64_t, const mechanics::NodeLinks::Turned*> link_of_;  // by the node that follows
  std::map<std::int64_t, std::int64_t> follower_of_;                     // by the node that is followed
  std::map<std::pair<int, std::int64_t>, std::int64_t> number_of_;       // by turns and own node
};

}  // namespace creepcontact::contact
