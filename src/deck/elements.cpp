#include "creepcontact/deck/elements.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "creepcontact/deck/cards.hpp"

namespace creepcontact::deck {
namespace {

using mesh::CellType;

struct Row {
  std::string_view name;
  CellType cell;
  Family family;
};

constexpr std::array rows{
    Row{"C3D4", CellType::tet4, Family::solid},
    Row{"C3D6", CellType::wedge6, Family::solid},
    Row{"C3D8", CellType::hex8, Family::solid},
    Row{"C3D10", CellType::tet10, Family::solid},
    Row{"C3D15", CellType::wedge15, Family::solid},
    Row{"C3D20", CellType::hex20, Family::solid},
    Row{"CAX3", CellType::tri3, Family::axisymmetric},
    Row{"CAX4", CellType::quad4, Family::axisymmetric},
    Row{"CAX6", CellType::tri6, Family::axisymmetric},
    Row{"CAX8", CellType::quad8, Family::axisymmetric},
    Row{"CPE3", CellType::tri3, Family::plane_strain},
    Row{"CPE4", CellType::quad4, Family::plane_strain},
    Row{"CPE6", CellType::tri6, Family::plane_strain},
    Row{"CPE8", CellType::quad8, Family::plane_strain},
    Row{"CPS3", CellType::tri3, Family::plane_stress},
    Row{"CPS4", CellType::quad4, Family::plane_stress},
    Row{"CPS6", CellType::tri6, Family::plane_stress},
    Row{"CPS8", CellType::quad8, Family::plane_stress},
    Row{"CPEG3", CellType::tri3, Family::generalized_plane_strain},
    Row{"CPEG4", CellType::quad4, Family::generalized_plane_strain},
    Row{"CPEG6", CellType::tri6, Family::generalized_plane_strain},
    Row{"CPEG8", CellType::quad8, Family::generalized_plane_strain},
};
constexpr std::string_view variants = "RHIM";

using Faces = std::vector<std::vector<int>>;
using Edges = std::vector<std::pair<int, int>>;

const Faces hex_faces{{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};
const Edges hex_edges{{1, 2}, {2, 3}, {3, 4}, {4, 1}, {5, 6}, {6, 7}, {7, 8}, {8, 5}, {1, 5}, {2, 6}, {3, 7}, {4, 8}};
const Faces tet_faces{{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}};
const Edges tet_edges{{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}};
const Faces wedge_faces{{1, 2, 3}, {4, 5, 6}, {1, 2, 5, 4}, {2, 3, 6, 5}, {3, 1, 4, 6}};
const Edges wedge_edges{{1, 2}, {2, 3}, {3, 1}, {4, 5}, {5, 6}, {6, 4}, {1, 4}, {2, 5}, {3, 6}};
const Faces quad_faces{{1, 2}, {2, 3}, {3, 4}, {4, 1}};
const Edges quad_edges{{1, 2}, {2, 3}, {3, 4}, {4, 1}};
const Faces tri_faces{{1, 2}, {2, 3}, {3, 1}};
const Edges tri_edges{{1, 2}, {2, 3}, {3, 1}};

const Faces& corners_of_faces(CellType cell) {
  switch (mesh::n_corners(cell)) {
    case 8:
      return hex_faces;
    case 6:
      return wedge_faces;
    case 3:
      return tri_faces;
    default:
      return mesh::dimension(cell) == 3 ? tet_faces : quad_faces;
  }
}

const Edges& edges_of(CellType cell) {
  switch (mesh::n_corners(cell)) {
    case 8:
      return hex_edges;
    case 6:
      return wedge_edges;
    case 3:
      return tri_edges;
    default:
      return mesh::dimension(cell) == 3 ? tet_edges : quad_edges;
  }
}

/// Place of the node between two corners, all from 0.
int between(CellType cell, int a, int b) {
  const Edges& edges = edges_of(cell);
  const auto found = std::ranges::find_if(edges, [&](const auto& edge) {
    return std::pair(edge.first - 1, edge.second - 1) == std::pair(a, b) ||
           std::pair(edge.second - 1, edge.first - 1) == std::pair(a, b);
  });
  return mesh::n_corners(cell) + static_cast<int>(found - edges.begin());
}

Faces faces_of(CellType cell) {
  Faces result;
  for (const std::vector<int>& corners : corners_of_faces(cell)) {
    std::vector<int> face;
    face.reserve(2 * corners.size());
    for (const int corner : corners) face.push_back(corner - 1);
    const std::size_t n = face.size();
    const std::size_t n_edges = n == 2 ? 1 : n;
    if (mesh::order(cell) == 2)
      for (std::size_t i = 0; i < n_edges; ++i) face.push_back(between(cell, face[i], face[(i + 1) % n]));
    result.push_back(std::move(face));
  }
  return result;
}

/// Numbers of the deck, from 1, at the places after the corners.
std::vector<int> after_corners(CellType cell) {
  switch (cell) {
    case CellType::hex20:
      return {9, 12, 17, 10, 18, 11, 19, 20, 13, 16, 14, 15};
    case CellType::wedge15:
      return {7, 9, 13, 8, 14, 15, 10, 12, 11};
    case CellType::tet10:
      return {5, 6, 7, 8, 10, 9};
    default:
      return {};
  }
}

}  // namespace

std::optional<ElementType> element_type(std::string_view name) {
  const std::string upper = upper_case(name);
  for (const Row& row : rows) {
    if (!upper.starts_with(row.name)) continue;
    const std::string rest = upper.substr(row.name.size());
    if (rest.find_first_not_of(variants) != std::string::npos) continue;  // C3D1 and C3D10, C3D8T
    return ElementType{std::string(name), row.cell, row.family, rest};
  }
  return std::nullopt;
}

const std::vector<int>& gmsh_order(CellType cell) {
  static std::map<CellType, std::vector<int>> orders = [] {
    std::map<CellType, std::vector<int>> all;
    for (const Row& row : rows) {
      std::vector<int>& order = all[row.cell];
      order.resize(static_cast<std::size_t>(mesh::n_nodes(row.cell)));
      std::iota(order.begin(), order.end(), 0);
      const std::vector<int> numbers = after_corners(row.cell);
      for (std::size_t i = 0; i < numbers.size(); ++i)
        order[static_cast<std::size_t>(mesh::n_corners(row.cell)) + i] = numbers[i] - 1;
    }
    return all;
  }();
  return orders.at(cell);
}

const std::vector<int>* face(CellType cell, int number) {
  static const std::map<CellType, Faces> faces = [] {
    std::map<CellType, Faces> all;
    for (const Row& row : rows) all[row.cell] = faces_of(row.cell);
    return all;
  }();
  const Faces& own = faces.at(cell);
  return number < 1 || number > static_cast<int>(own.size()) ? nullptr : &own[static_cast<std::size_t>(number) - 1];
}

}  // namespace creepcontact::deck
