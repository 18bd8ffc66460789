#pragma once
/// Kinds of mesh cells. Node numbering within a cell is Gmsh's throughout the program.

#include <string_view>
#include <vector>

namespace creepcontact::mesh {

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

/// All of them, in the order of the enumeration.
const std::vector<CellType>& cell_types();
/// Those of dimension 3.
const std::vector<CellType>& volume_cell_types();

int dimension(CellType type);
int n_nodes(CellType type);
int n_corners(CellType type);
/// 1 linear, 2 quadratic
int order(CellType type);
std::string_view name(CellType type);

}  // namespace creepcontact::mesh
