#pragma once
/// Small meshes made in code, for the tests of mechanics and contact.

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "creepcontact/mesh/cell_faces.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::test {

using mesh::CellType;

inline constexpr std::array volume_types{CellType::tet4,  CellType::tet10,  CellType::hex8,   CellType::hex20,
                                         CellType::hex27, CellType::wedge6, CellType::wedge15};

namespace detail {

/// Twice the grid index, so that the middle of any edge, face or cell has whole numbers too.
using GridPoint = std::array<int, 3>;

/// Cells of the unit grid cell by their corners (as bits x + 2 y + 4 z): 1 hexahedron, 2 wedges or 6 tetrahedra, the
/// same in every grid cell and fitting its neighbours.
inline std::vector<std::vector<int>> corner_bits(CellType type) {
  switch (mesh::n_corners(type)) {
    case 8:
      return {{0, 1, 3, 2, 4, 5, 7, 6}};
    case 6:
      return {{0, 1, 3, 4, 5, 7}, {0, 3, 2, 4, 7, 6}};
    default:
      return {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  }
}

inline GridPoint middle(const std::vector<GridPoint>& corners) {
  GridPoint sum{};
  for (const GridPoint& corner : corners)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += corner[i];
  for (int& component : sum) component /= static_cast<int>(corners.size());
  return sum;
}

/// All nodes of a cell in Gmsh's order, from its corners.
inline std::vector<GridPoint> cell_nodes(CellType type, const std::vector<GridPoint>& corners) {
  std::vector<GridPoint> nodes = corners;
  if (mesh::order(type) == 1) return nodes;
  for (const auto& [a, b] : mesh::cell_edges(type))
    nodes.push_back(middle({corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]}));
  if (type != CellType::hex27) return nodes;
  for (const mesh::LocalFace& face : mesh::cell_faces(type)) {
    std::vector<GridPoint> around;
    for (std::size_t i = 0; i < 4; ++i) around.push_back(corners[static_cast<std::size_t>(face.nodes[i])]);
    nodes.push_back(middle(around));
  }
  nodes.push_back(middle(corners));
  return nodes;
}

}  // namespace detail

/// A box of nx x ny x nz grid cells of one element type.
/// Groups: "volume", and the surfaces "x0", "x1", "y0", "y1", "z0", "z1" with their cells.
/// @param distortion  corner nodes inside the box are moved by up to this part of a grid cell (same every time);
///                    middle nodes stay in the middle of their corners
inline mesh::Mesh box_mesh(CellType type, std::array<int, 3> divisions, const Vector3& lengths = Vector3::Ones(),
                           const Vector3& origin = Vector3::Zero(), double distortion = 0) {
  using detail::GridPoint;
  std::map<GridPoint, Vector3> corner_places;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shift(-distortion, distortion);
  for (int k = 0; k <= divisions[2]; ++k) {
    for (int j = 0; j <= divisions[1]; ++j) {
      for (int i = 0; i <= divisions[0]; ++i) {
        const std::array index{i, j, k};
        Vector3 place(i, j, k);
        const bool inside = std::ranges::all_of(std::array{0, 1, 2}, [&](int c) {
          const auto axis = static_cast<std::size_t>(c);
          return index[axis] > 0 && index[axis] < divisions[axis];
        });
        if (inside && distortion > 0) place += Vector3(shift(generator), shift(generator), shift(generator));
        for (int c = 0; c < 3; ++c) place[c] *= lengths[c] / divisions[static_cast<std::size_t>(c)];
        corner_places[{2 * i, 2 * j, 2 * k}] = origin + place;
      }
    }
  }

  mesh::Mesh mesh;
  std::map<GridPoint, std::int64_t> numbers;
  const auto number = [&](const GridPoint& point) {
    const auto [entry, is_new] = numbers.try_emplace(point, static_cast<std::int64_t>(mesh.nodes.size()));
    if (is_new) {
      // The mean of the corners around: 1, 2, 4 or 8 of them, or the 2 ends of a diagonal, which only simplices have.
      const bool simplex = mesh::n_corners(type) == 4;
      const bool diagonal_in_xy = mesh::n_corners(type) == 6 && point[0] % 2 != 0 && point[1] % 2 != 0;
      const GridPoint odd{point[0] & 1, point[1] & 1, point[2] & 1};
      Vector3 sum = Vector3::Zero();
      int count = 0;
      for (int bits = 0; bits < 8; ++bits) {
        const GridPoint sign{bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1};
        bool used = true;
        for (std::size_t c = 0; c < 3; ++c) used = used && (odd[c] == 1 || sign[c] == 1);
        if (simplex || diagonal_in_xy) {  // all diagonals run in the direction (1, 1, 1), within their plane
          const std::size_t n = simplex ? 3 : 2;
          int first = 0;
          for (std::size_t c = 0; c < n; ++c) {
            if (odd[c] == 0) continue;
            if (first == 0) first = sign[c];
            used = used && sign[c] == first;
          }
        }
        if (!used) continue;
        sum +=
            corner_places.at({point[0] + odd[0] * sign[0], point[1] + odd[1] * sign[1], point[2] + odd[2] * sign[2]});
        ++count;
      }
      mesh.nodes.push_back(sum / count);
    }
    return entry->second;
  };

  mesh::CellBlock volume{type, {}};
  std::map<CellType, mesh::CellBlock> surface_blocks;
  struct SurfaceCell {
    std::string group;
    CellType type;
    std::size_t cell;
  };
  std::vector<SurfaceCell> surface_cells;
  for (int k = 0; k < divisions[2]; ++k) {
    for (int j = 0; j < divisions[1]; ++j) {
      for (int i = 0; i < divisions[0]; ++i) {
        for (const std::vector<int>& bits : detail::corner_bits(type)) {
          std::vector<GridPoint> corners;
          for (const int b : bits) corners.push_back({2 * (i + (b & 1)), 2 * (j + (b >> 1 & 1)), 2 * (k + (b >> 2))});
          const std::vector<GridPoint> points = detail::cell_nodes(type, corners);
          for (const GridPoint& point : points) volume.connectivity.push_back(number(point));
          for (const mesh::LocalFace& face : mesh::cell_faces(type)) {
            for (std::size_t c = 0; c < 3; ++c) {
              for (const int side : {0, 1}) {
                const bool on_side = std::ranges::all_of(face.nodes, [&](int n) {
                  return points[static_cast<std::size_t>(n)][c] == 2 * side * divisions[c];
                });
                if (!on_side) continue;
                mesh::CellBlock& block =
                    surface_blocks.try_emplace(face.type, mesh::CellBlock{face.type, {}}).first->second;
                surface_cells.push_back({std::string(1, "xyz"[c]) + (side == 0 ? "0" : "1"), face.type, block.size()});
                for (const int n : face.nodes)
                  block.connectivity.push_back(number(points[static_cast<std::size_t>(n)]));
              }
            }
          }
        }
      }
    }
  }

  mesh::Group all{"volume", 3, {}};
  for (std::size_t cell = 0; cell < volume.size(); ++cell) all.cells.push_back({0, cell});
  mesh.groups["volume"] = all;
  mesh.blocks.push_back(std::move(volume));
  std::map<CellType, std::size_t> block_numbers;
  for (auto& [face_type, block] : surface_blocks) {
    block_numbers[face_type] = mesh.blocks.size();
    mesh.blocks.push_back(std::move(block));
  }
  for (const SurfaceCell& cell : surface_cells) {
    mesh::Group& group = mesh.groups.try_emplace(cell.group, mesh::Group{cell.group, 2, {}}).first->second;
    group.cells.push_back({block_numbers[cell.type], cell.cell});
  }
  return mesh;
}

/// The mesh with its nodes moved to map(x); middle nodes too, so that faces may become curved.
template <typename Map>
mesh::Mesh mapped(mesh::Mesh mesh, const Map& map) {
  for (Vector3& x : mesh.nodes) x = map(x);
  return mesh;
}

}  // namespace creepcontact::test
