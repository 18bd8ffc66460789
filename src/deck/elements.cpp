#include "creepcontact/deck/elements.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "creepcontact/deck/cards.hpp"
#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::deck {
namespace {

using mesh::CellType;
using settings::Analysis;

struct Row {
  std::string_view name;
  CellType cell;
  Analysis analysis;
};

constexpr std::array rows{
    Row{"C3D4", CellType::tet4, Analysis::solid},
    Row{"C3D6", CellType::wedge6, Analysis::solid},
    Row{"C3D8", CellType::hex8, Analysis::solid},
    Row{"C3D10", CellType::tet10, Analysis::solid},
    Row{"C3D15", CellType::wedge15, Analysis::solid},
    Row{"C3D20", CellType::hex20, Analysis::solid},
    Row{"DC3D4", CellType::tet4, Analysis::solid},
    Row{"DC3D6", CellType::wedge6, Analysis::solid},
    Row{"DC3D8", CellType::hex8, Analysis::solid},
    Row{"DC3D10", CellType::tet10, Analysis::solid},
    Row{"DC3D15", CellType::wedge15, Analysis::solid},
    Row{"DC3D20", CellType::hex20, Analysis::solid},
    Row{"DC2D3", CellType::tri3, Analysis::plane_strain},
    Row{"DC2D4", CellType::quad4, Analysis::plane_strain},
    Row{"DC2D6", CellType::tri6, Analysis::plane_strain},
    Row{"DC2D8", CellType::quad8, Analysis::plane_strain},
    Row{"DCAX3", CellType::tri3, Analysis::axisymmetric},
    Row{"DCAX4", CellType::quad4, Analysis::axisymmetric},
    Row{"DCAX6", CellType::tri6, Analysis::axisymmetric},
    Row{"DCAX8", CellType::quad8, Analysis::axisymmetric},
    Row{"CAX3", CellType::tri3, Analysis::axisymmetric},
    Row{"CAX4", CellType::quad4, Analysis::axisymmetric},
    Row{"CAX6", CellType::tri6, Analysis::axisymmetric},
    Row{"CAX8", CellType::quad8, Analysis::axisymmetric},
    Row{"CPE3", CellType::tri3, Analysis::plane_strain},
    Row{"CPE4", CellType::quad4, Analysis::plane_strain},
    Row{"CPE6", CellType::tri6, Analysis::plane_strain},
    Row{"CPE8", CellType::quad8, Analysis::plane_strain},
    Row{"CPS3", CellType::tri3, Analysis::plane_stress},
    Row{"CPS4", CellType::quad4, Analysis::plane_stress},
    Row{"CPS6", CellType::tri6, Analysis::plane_stress},
    Row{"CPS8", CellType::quad8, Analysis::plane_stress},
    Row{"CPEG3", CellType::tri3, Analysis::generalized_plane_strain},
    Row{"CPEG4", CellType::quad4, Analysis::generalized_plane_strain},
    Row{"CPEG6", CellType::tri6, Analysis::generalized_plane_strain},
    Row{"CPEG8", CellType::quad8, Analysis::generalized_plane_strain},
};
constexpr std::string_view variants = "RHIMT";

/// Corners of faces and edges by their numbers in a deck, from 1.
struct Shape {
  std::vector<std::vector<int>> faces;
  std::vector<std::pair<int, int>> edges;
};

const Shape& shape(CellType cell) {
  static const Shape hexahedron{
      {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}},
      {{1, 2}, {2, 3}, {3, 4}, {4, 1}, {5, 6}, {6, 7}, {7, 8}, {8, 5}, {1, 5}, {2, 6}, {3, 7}, {4, 8}}};
  static const Shape wedge{{{1, 2, 3}, {4, 5, 6}, {1, 2, 5, 4}, {2, 3, 6, 5}, {3, 1, 4, 6}},
                           {{1, 2}, {2, 3}, {3, 1}, {4, 5}, {5, 6}, {6, 4}, {1, 4}, {2, 5}, {3, 6}}};
  static const Shape tetrahedron{{{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}},
                                 {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}}};
  static const Shape quadrilateral{{{1, 2}, {2, 3}, {3, 4}, {4, 1}}, {{1, 2}, {2, 3}, {3, 4}, {4, 1}}};
  static const Shape triangle{{{1, 2}, {2, 3}, {3, 1}}, {{1, 2}, {2, 3}, {3, 1}}};
  switch (mesh::linear_type(cell)) {
    case CellType::hex8:
      return hexahedron;
    case CellType::wedge6:
      return wedge;
    case CellType::tet4:
      return tetrahedron;
    case CellType::quad4:
      return quadrilateral;
    default:
      return triangle;
  }
}

/// Place of the node between two corners, all from 0.
int between(CellType cell, int a, int b) {
  const auto& edges = shape(cell).edges;
  const auto found = std::ranges::find_if(edges, [&](const auto& edge) {
    return std::pair(edge.first - 1, edge.second - 1) == std::pair(a, b) ||
           std::pair(edge.second - 1, edge.first - 1) == std::pair(a, b);
  });
  return mesh::n_corners(cell) + static_cast<int>(found - edges.begin());
}

std::vector<std::vector<int>> faces_of(CellType cell) {
  std::vector<std::vector<int>> result;
  for (const std::vector<int>& corners : shape(cell).faces) {
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

}  // namespace

std::optional<ElementType> element_type(std::string_view name) {
  const std::string upper = upper_case(name);
  for (const Row& row : rows) {
    if (!upper.starts_with(row.name)) continue;
    const std::string rest = upper.substr(row.name.size());
    if (rest.find_first_not_of(variants) != std::string::npos) continue;  // C3D1 and C3D10, C3D8P
    return ElementType{std::string(name), row.cell, row.analysis, rest};
  }
  return std::nullopt;
}

std::optional<std::size_t> n_nodes_of_skin(std::string_view name) {
  static const std::map<std::string, std::size_t> all{
      {"T2D2", 2}, {"T3D2", 2}, {"T3D3", 3}, {"B21", 2},   {"B22", 3},    {"B31", 2},  {"B31R", 2}, {"B32", 3},
      {"B32R", 3}, {"S3", 3},   {"S3R", 3},  {"STRI3", 3}, {"STRI65", 6}, {"S4", 4},   {"S4R", 4},  {"S6", 6},
      {"S8", 8},   {"S8R", 8},  {"M3D3", 3}, {"M3D4", 4},  {"M3D4R", 4},  {"M3D6", 6}, {"M3D8", 8}, {"M3D8R", 8}};
  const auto found = all.find(upper_case(name));
  return found == all.end() ? std::nullopt : std::optional(found->second);
}

std::optional<GasketShape> gasket_shape(std::string_view name) {
  struct Gasket {
    std::string_view name;
    std::size_t n_nodes;
    int n_corners;  // of a side
    int upper;      // place of the first corner of the upper side
  };
  static constexpr std::array gaskets{Gasket{"GK3D6", 6, 3, 3},   Gasket{"GK3D8", 8, 4, 4}, Gasket{"GK3D12M", 12, 3, 6},
                                      Gasket{"GK3D18", 18, 4, 8}, Gasket{"GKAX4", 4, 2, 2}, Gasket{"GKPE4", 4, 2, 2},
                                      Gasket{"GKPS4", 4, 2, 2}};
  const std::string upper = upper_case(name);
  for (const Gasket& gasket : gaskets) {
    if (upper != gasket.name && upper != std::string(gasket.name) + "N") continue;
    GasketShape shape{gasket.n_nodes, {}, upper == gasket.name};
    for (int i = 0; i < gasket.n_corners; ++i) {
      shape.corners[0].push_back(i);
      shape.corners[1].push_back(gasket.upper + i);
    }
    return shape;
  }
  return std::nullopt;
}

const std::vector<int>& gmsh_order(CellType cell) {
  static const std::map<CellType, std::vector<int>> orders = [] {
    std::map<CellType, std::vector<int>> all;
    for (const Row& row : rows) {
      std::vector<int>& order = all[row.cell];
      order.resize(static_cast<std::size_t>(mesh::n_nodes(row.cell)));
      std::iota(order.begin(), order.end(), 0);
      if (mesh::order(row.cell) == 1) continue;
      const auto& edges = mesh::cell_edges(row.cell);
      for (std::size_t i = 0; i < edges.size(); ++i)
        order[static_cast<std::size_t>(mesh::n_corners(row.cell)) + i] = between(row.cell, edges[i][0], edges[i][1]);
    }
    return all;
  }();
  return orders.at(cell);
}

const std::vector<int>* face(CellType cell, int number) {
  static const std::map<CellType, std::vector<std::vector<int>>> faces = [] {
    std::map<CellType, std::vector<std::vector<int>>> all;
    for (const Row& row : rows) all[row.cell] = faces_of(row.cell);
    return all;
  }();
  const auto& own = faces.at(cell);
  return number < 1 || number > static_cast<int>(own.size()) ? nullptr : &own[static_cast<std::size_t>(number) - 1];
}

}  // namespace creepcontact::deck
