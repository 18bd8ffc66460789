#pragma once
/// Types of mesh cells. Node numbering within a cell is that of Gmsh throughout the program.

#include <string_view>
#include <vector>

namespace creepcontact::mesh {

/// Named by shape and number of nodes.
enum class CellType {
  point1,
  line2,
  line3,
  tri3,
  tri6,
  quad4,
  quad8,
  quad9,
  tet4,
  tet10,
  hex8,
  hex20,
  hex27,
  wedge6,
  wedge15
};

/// All types, in the order of the enumeration.
const std::vector<CellType>& cell_types();
/// Types of dimension 3.
const std::vector<CellType>& volume_cell_types();

int dimension(CellType type);
int n_nodes(CellType type);
int n_corners(CellType type);
/// 1: linear, 2: quadratic.
int order(CellType type);
/// The linear type of the same shape. Precondition: a volume or surface type
CellType linear_type(CellType type);
/// The name as in the enumeration: "hex20".
std::string_view name(CellType type);

}  // namespace creepcontact::mesh
