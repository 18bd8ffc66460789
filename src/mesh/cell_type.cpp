#include "creepcontact/mesh/cell_type.hpp"

#include <array>

namespace creepcontact::mesh {
namespace {

struct Properties {
  std::string_view name;
  int dimension, n_nodes, n_corners, order;
};

// In the order of the enumeration. A point counts as linear.
constexpr std::array<Properties, 15> properties{{{"point1", 0, 1, 1, 1},
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
                                                 {"wedge15", 3, 15, 6, 2}}};

const Properties& of(CellType type) {
  return properties[static_cast<std::size_t>(type)];
}

}  // namespace

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
std::string_view name(CellType type) {
  return of(type).name;
}

}  // namespace creepcontact::mesh
