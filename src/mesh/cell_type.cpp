#include "creepcontact/mesh/cell_type.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace creepcontact::mesh {
namespace {

struct Properties {
  std::string_view name;
  int dimension, n_nodes, n_corners, order;
};

// In the order of the enumeration. A point counts as linear.
constexpr auto properties = std::to_array<Properties>({{"point1", 0, 1, 1, 1},
                                                       {"line2", 1, 2, 2, 1},
                                                       {"line3", 1, 3, 2, 2},
                                                       {"tri3", 2, 3, 3, 1},
                                                       {"tri6", 2, 6, 3, 2},
                                                       {"quad4", 2, 4, 4, 1},
                                                       {"quad8", 2, 8, 4, 2},
                                                       {"quad9", 2, 9, 4, 2},
                                                       {"tet4", 3, 4, 4, 1},
                                                       {"tet10", 3, 10, 4, 2},
                                                       {"hex8", 3, 8, 8, 1},
                                                       {"hex20", 3, 20, 8, 2},
                                                       {"hex27", 3, 27, 8, 2},
                                                       {"wedge6", 3, 6, 6, 1},
                                                       {"wedge15", 3, 15, 6, 2}});

const Properties& of(CellType type) {
  return properties[static_cast<std::size_t>(type)];
}

}  // namespace

const std::vector<CellType>& cell_types() {
  static const std::vector<CellType> types = [] {
    std::vector<CellType> all;
    all.reserve(properties.size());
    for (std::size_t i = 0; i < properties.size(); ++i) all.push_back(static_cast<CellType>(i));
    return all;
  }();
  return types;
}

const std::vector<CellType>& volume_cell_types() {
  static const std::vector<CellType> types = [] {
    std::vector<CellType> volumes;
    std::ranges::copy_if(cell_types(), std::back_inserter(volumes), [](CellType type) { return dimension(type) == 3; });
    return volumes;
  }();
  return types;
}

int dimension(CellType type) {
  return of(type).dimension;
}
int n_nodes(CellType type) {
  return of(type).n_nodes;
}
int n_corners(CellType type) {
  return of(type).n_corners;
}
int order(CellType type) {
  return of(type).order;
}
CellType linear_type(CellType type) {
  switch (n_corners(type)) {
    case 3:
      return CellType::tri3;
    case 4:
      return dimension(type) == 2 ? CellType::quad4 : CellType::tet4;
    case 6:
      return CellType::wedge6;
    default:
      return CellType::hex8;
  }
}

std::string_view name(CellType type) {
  return of(type).name;
}

}  // namespace creepcontact::mesh
