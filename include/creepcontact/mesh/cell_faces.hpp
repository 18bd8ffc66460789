#pragma once
/// Edges and faces of the reference cells in the node numbering of Gmsh.

#include <array>
#include <vector>

#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::mesh {

/// A face of a volume cell; by the right-hand rule its nodes give the outward normal. The faces of a surface
/// cell are its edges, with the cell on their left.
struct LocalFace {
  CellType type{};
  std::vector<int> nodes;  ///< local nodes of the cell, in the Gmsh order of `type` (corners, mid-edges, mid-face)
};

/// Corner nodes of every edge, in the order in which Gmsh numbers the mid-edge nodes: in a quadratic cell the node on
/// edge i is n_corners + i. Empty for points. Cost: none.
const std::vector<std::array<int, 2>>& cell_edges(CellType type);

/// Faces of a volume cell, edges of a surface cell; empty for curves and points. hex8: quad4, hex20: quad8, hex27:
/// quad9 (in the order of the mid-face nodes 20..25 of Gmsh), tet4: tri3, tet10: tri6, wedge6 and wedge15: two
/// triangles, then three quadrilaterals. Cost: none after the first call.
const std::vector<LocalFace>& cell_faces(CellType type);

}  // namespace creepcontact::mesh
