#include "reference_nodes.hpp"

#include <stdexcept>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::fem {

namespace {

using mesh::CellType;

std::vector<Vector3> corners(CellType type) {
  switch (mesh::n_corners(type) + 10 * mesh::dimension(type)) {
    case 12:
      return {{-1, 0, 0}, {1, 0, 0}};
    case 23:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    case 24:
      return {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    case 34:
      return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case 36:
      return {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    case 38:
      return {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    default:
      throw std::invalid_argument("no reference element for a point");
  }
}

}  // namespace

Eigen::MatrixX3d reference_nodes(CellType type) {
  const std::vector<Vector3> corner = corners(type);
  const Index n_corners = mesh::n_corners(type), n_nodes = mesh::n_nodes(type);
  Eigen::MatrixX3d nodes = Eigen::MatrixX3d::Zero(n_nodes, 3);  // a node in the middle of a quad9 or hex27 stays there
  for (Index i = 0; i < n_corners; ++i) nodes.row(i) = corner[i];
  if (mesh::order(type) == 1) return nodes;
  Index node = n_corners;
  for (const auto& [a, b] : mesh::cell_edges(type)) nodes.row(node++) = 0.5 * (nodes.row(a) + nodes.row(b));
  for (const mesh::LocalFace& face : mesh::cell_faces(type)) {
    if (face.type != CellType::quad9) continue;
    nodes.row(face.nodes[8]) = 0.25 * (nodes.row(face.nodes[0]) + nodes.row(face.nodes[1]) + nodes.row(face.nodes[2]) +
                                       nodes.row(face.nodes[3]));
  }
  return nodes;
}

}  // namespace creepcontact::fem
