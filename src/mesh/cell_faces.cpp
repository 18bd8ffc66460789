#include "creepcontact/mesh/cell_faces.hpp"

#include <algorithm>
#include <map>

namespace creepcontact::mesh {
namespace {

using Edges = std::vector<std::array<int, 2>>;
using Corners = std::vector<std::vector<int>>;

// Corners of the faces, outward; the hexahedron's in the order of Gmsh's mid-face nodes.
const Corners& face_corners(int n_corners) {
  static const Corners tetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  static const Corners wedge{{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static const Corners hexahedron{{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {3, 7, 6, 2}, {4, 5, 6, 7}};
  return n_corners == 4 ? tetrahedron : n_corners == 6 ? wedge : hexahedron;
}

int mid_edge_node(CellType type, int a, int b) {
  const Edges& edges = cell_edges(type);
  const auto found = std::find_if(edges.begin(), edges.end(),
                                  [&](const auto& edge) { return std::minmax(a, b) == std::minmax(edge[0], edge[1]); });
  return n_corners(type) + static_cast<int>(found - edges.begin());
}

CellType face_type(CellType cell, std::size_t corners) {
  if (corners == 3) return order(cell) == 1 ? CellType::tri3 : CellType::tri6;
  if (order(cell) == 1) return CellType::quad4;
  return cell == CellType::hex27 ? CellType::quad9 : CellType::quad8;
}

std::vector<LocalFace> make_faces(CellType type) {
  std::vector<LocalFace> faces;
  if (dimension(type) == 2)
    for (const auto& [a, b] : cell_edges(type)) {
      faces.push_back({order(type) == 1 ? CellType::line2 : CellType::line3, {a, b}});
      if (order(type) == 2) faces.back().nodes.push_back(mid_edge_node(type, a, b));
    }
  if (dimension(type) < 3) return faces;
  for (const std::vector<int>& corners : face_corners(n_corners(type))) {
    LocalFace face{face_type(type, corners.size()), corners};
    if (order(type) == 2) {
      for (std::size_t i = 0; i < corners.size(); ++i)
        face.nodes.push_back(mid_edge_node(type, corners[i], corners[(i + 1) % corners.size()]));
    }
    if (type == CellType::hex27) face.nodes.push_back(20 + static_cast<int>(faces.size()));
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace

const Edges& cell_edges(CellType type) {
  static const Edges none;
  static const Edges line{{0, 1}};
  static const Edges triangle{{0, 1}, {1, 2}, {2, 0}};
  static const Edges quadrilateral{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  static const Edges tetrahedron{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}};
  static const Edges wedge{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}};
  static const Edges hexahedron{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3},
                                {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}};
  switch (dimension(type)) {
    case 0:
      return none;
    case 1:
      return line;
    case 2:
      return n_corners(type) == 3 ? triangle : quadrilateral;
    default:
      return n_corners(type) == 4 ? tetrahedron : n_corners(type) == 6 ? wedge : hexahedron;
  }
}

const std::vector<LocalFace>& cell_faces(CellType type) {
  static const std::map<CellType, std::vector<LocalFace>> faces = [] {
    std::map<CellType, std::vector<LocalFace>> all;
    for (const CellType cell : cell_types()) all.emplace(cell, make_faces(cell));
    return all;
  }();
  return faces.at(type);
}

}  // namespace creepcontact::mesh
