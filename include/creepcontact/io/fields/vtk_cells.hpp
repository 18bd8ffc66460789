#pragma once
/// VTK's names and node order of the mesh cells.

#include <cstdint>
#include <span>

#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::io {

/// Number of the cell in vtkCellType.h.
std::uint8_t vtk_cell_type(mesh::CellType type);

/// Node i of VTK's cell is node vtk_order(type)[i] of Gmsh's.
std::span<const int> vtk_order(mesh::CellType type);

}  // namespace creepcontact::io
