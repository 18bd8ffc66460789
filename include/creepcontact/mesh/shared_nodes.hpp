#pragma once
/// What bodies cut from one mesh have in common.

#include <cstdint>
#include <span>
#include <vector>

#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mesh {

/// A node that several bodies have.
struct SharedNode {
  struct Owner {
    std::size_t body = 0;
    std::int64_t node = 0;  ///< its number there
  };
  std::vector<Owner> owners;  ///< at least two, by body
};

/// A face between cells of two bodies.
struct SharedFace {
  std::size_t first = 0, second = 0;  ///< bodies, ascending
  std::vector<std::size_t> nodes;     ///< indices into SharedMesh::nodes
  double area = 0;                    ///< of the polygon of its corners
};

struct SharedMesh {
  std::vector<SharedNode> nodes;
  std::vector<SharedFace> faces;
};

/// @param bodies  extracted from one mesh. Cost: one pass over the cells if any node is shared
SharedMesh shared_mesh(std::span<const BodyMesh> bodies);

}  // namespace creepcontact::mesh
