#pragma once
// Node coordinates of the reference cells as Gmsh's manual draws them ("Node ordering"), independent of the tables
// tested.

#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::mesh::test {

inline std::vector<Vector3> first(const std::vector<Vector3>& nodes, int n) {
  return {nodes.begin(), nodes.begin() + n};
}

inline std::vector<Vector3> reference_nodes(CellType type) {
  static const std::vector<Vector3> tet{{0, 0, 0},   {1, 0, 0},  {0, 1, 0},  {0, 0, 1},   {.5, 0, 0},
                                        {.5, .5, 0}, {0, .5, 0}, {0, 0, .5}, {0, .5, .5}, {.5, 0, .5}};
  static const std::vector<Vector3> wedge{{0, 0, -1}, {1, 0, -1},  {0, 1, -1},  {0, 0, 1},  {1, 0, 1},
                                          {0, 1, 1},  {.5, 0, -1}, {0, .5, -1}, {0, 0, 0},  {.5, .5, -1},
                                          {1, 0, 0},  {0, 1, 0},   {.5, 0, 1},  {0, .5, 1}, {.5, .5, 1}};
  static const std::vector<Vector3> hex{
      {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},  {-1, 1, 1}, {0, -1, -1},
      {-1, 0, -1},  {-1, -1, 0}, {1, 0, -1}, {1, -1, 0},  {0, 1, -1},  {1, 1, 0},  {-1, 1, 0}, {0, -1, 1}, {-1, 0, 1},
      {1, 0, 1},    {0, 1, 1},   {0, 0, -1}, {0, -1, 0},  {-1, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {0, 0, 0}};
  switch (type) {
    case CellType::tet4:
    case CellType::tet10:
      return first(tet, n_nodes(type));
    case CellType::wedge6:
    case CellType::wedge15:
      return first(wedge, n_nodes(type));
    default:
      return first(hex, n_nodes(type));
  }
}

}  // namespace creepcontact::mesh::test
