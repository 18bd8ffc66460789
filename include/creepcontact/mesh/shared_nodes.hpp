#pragma once
/// Nodes and faces shared by bodies that were cut from one mesh.

#include <cstdint>
#include <span>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {

/// A node that belongs to several bodies.
struct SharedNode {
  struct Owner {
    std::size_t body = 0;
    std::int64_t node = 0;  ///< its number in that body
  };
  std::vector<Owner> owners;  ///< at least two, in ascending order of body
};

/// A face between cells of two bodies.
struct SharedFace {
  std::size_t first = 0, second = 0;  ///< bodies, ascending
  std::vector<std::size_t> nodes;     ///< indices into SharedMesh::nodes
  double area = 0;                    ///< of the polygon of its corners [length^2]
};

/// All of them.
struct SharedMesh {
  std::vector<SharedNode> nodes;
  std::vector<SharedFace> faces;
};

/// @param bodies  extracted from the same mesh. Cost: one pass over the cells if any node is shared
SharedMesh shared_mesh(std::span<const BodyMesh> bodies);

}  // namespace creepcontact::mesh
