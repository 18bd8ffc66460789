#include "surfaces.hpp"

#include <algorithm>
#include <span>

#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/outer_faces.hpp"

namespace creepcontact::report {
namespace {

using Corners = std::array<int, 3>;

/// A face as triangles between its nodes.
std::span<const Corners> triangles_of(mesh::CellType type) {
  static constexpr std::array<Corners, 1> tri3{{{0, 1, 2}}};
  static constexpr std::array<Corners, 4> tri6{{{0, 3, 5}, {3, 1, 4}, {4, 2, 5}, {3, 4, 5}}};
  static constexpr std::array<Corners, 2> quad4{{{0, 1, 2}, {0, 2, 3}}};
  static constexpr std::array<Corners, 6> quad8{{{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}}};
  static constexpr std::array<Corners, 8> quad9{
      {{0, 4, 8}, {4, 1, 8}, {1, 5, 8}, {5, 2, 8}, {2, 6, 8}, {6, 3, 8}, {3, 7, 8}, {7, 0, 8}}};
  switch (type) {
    case mesh::CellType::tri3:
      return tri3;
    case mesh::CellType::tri6:
      return tri6;
    case mesh::CellType::quad4:
      return quad4;
    case mesh::CellType::quad8:
      return quad8;
    case mesh::CellType::quad9:
      return quad9;
    default:
      return {};
  }
}

/// A volume cell as tetrahedra between its corners.
std::span<const std::array<int, 4>> tetrahedra_of(mesh::CellType type) {
  static constexpr std::array<std::array<int, 4>, 1> tet{{{0, 1, 2, 3}}};
  static constexpr std::array<std::array<int, 4>, 3> wedge{{{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}};
  static constexpr std::array<std::array<int, 4>, 6> hex{
      {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
  if (mesh::dimension(type) != 3) return {};
  switch (mesh::n_corners(type)) {
    case 4:
      return tet;
    case 6:
      return wedge;
    default:
      return hex;
  }
}

void add_face(mesh::CellType type, std::span<const std::int64_t> nodes, BodyShape& shape) {
  const auto at = [&](int i) { return nodes[static_cast<std::size_t>(i)]; };
  for (const Corners& corners : triangles_of(type))
    shape.triangles.push_back({at(corners[0]), at(corners[1]), at(corners[2])});
  const auto& edges = mesh::cell_edges(type);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::int64_t a = at(edges[e][0]), b = at(edges[e][1]);
    const auto add = [&](std::int64_t from, std::int64_t to) {
      shape.edges.push_back({std::min(from, to), std::max(from, to)});
    };
    if (mesh::order(type) == 1) {
      add(a, b);
    } else {
      const std::int64_t middle = at(mesh::n_corners(type) + static_cast<int>(e));
      add(a, middle);
      add(middle, b);
    }
  }
}

}  // namespace

bool is_flat(const io::FieldMesh& mesh) {
  return std::ranges::none_of(mesh.blocks,
                              [](const mesh::CellBlock& block) { return mesh::dimension(block.type) == 3; });
}

std::vector<BodyShape> shapes(const io::FieldMesh& mesh, const std::vector<std::size_t>& body_of,
                              std::size_t n_bodies) {
  std::vector<BodyShape> result(n_bodies);
  const auto shape_of = [&](std::int64_t node) -> BodyShape& {
    return result[body_of[static_cast<std::size_t>(node)]];
  };
  if (!is_flat(mesh))
    for (const mesh::Face& face : mesh::outer_faces(mesh.blocks, 3))
      add_face(face.type, face.nodes, shape_of(face.nodes[0]));
  for (const mesh::CellBlock& block : mesh.blocks) {
    const auto tetrahedra = tetrahedra_of(block.type);
    for (std::size_t c = 0; c < block.size(); ++c) {
      const std::span<const std::int64_t> nodes = block.cell(c);
      if (is_flat(mesh) && mesh::dimension(block.type) == 2) add_face(block.type, nodes, shape_of(nodes[0]));
      for (const std::array<int, 4>& corners : tetrahedra) {
        const auto at = [&](std::size_t i) { return nodes[static_cast<std::size_t>(corners[i])]; };
        shape_of(nodes[0]).tetrahedra.push_back({at(0), at(1), at(2), at(3)});
      }
    }
  }
  for (BodyShape& shape : result) {
    std::ranges::sort(shape.edges);
    shape.edges.erase(std::unique(shape.edges.begin(), shape.edges.end()), shape.edges.end());
  }
  return result;
}

}  // namespace creepcontact::report
