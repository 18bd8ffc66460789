#include "creepcontact/io/fields/vtk_cells.hpp"

#include <array>
#include <numeric>
#include <stdexcept>

namespace creepcontact::io {

using mesh::CellType;

std::uint8_t vtk_cell_type(CellType type) {
  switch (type) {
    case CellType::point1:
      return 1;
    case CellType::line2:
      return 3;
    case CellType::line3:
      return 21;
    case CellType::tri3:
      return 5;
    case CellType::tri6:
      return 22;
    case CellType::quad4:
      return 9;
    case CellType::quad8:
      return 23;
    case CellType::quad9:
      return 28;
    case CellType::tet4:
      return 10;
    case CellType::tet10:
      return 24;
    case CellType::hex8:
      return 12;
    case CellType::hex20:
      return 25;
    case CellType::hex27:
      return 29;
    case CellType::wedge6:
      return 13;
    case CellType::wedge15:
      return 26;
  }
  throw std::invalid_argument("no cell type of VTK");
}

std::span<const int> vtk_order(CellType type) {
  static constexpr std::array tet10{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  // Edges of the bottom, of the top, upright ones; then, hex27 only, the faces -x +x -y +y -z +z and the middle.
  static constexpr std::array hex27{0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                                    19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26};
  // VTK wants the normal of a wedge's first triangle to point outward, Gmsh inward: both triangles are turned over.
  static constexpr std::array wedge15{0, 2, 1, 3, 5, 4, 7, 9, 6, 13, 14, 12, 8, 11, 10};
  static const auto same = [] {
    std::array<int, 27> numbers{};
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }();
  const std::size_t n = mesh::n_nodes(type);
  switch (type) {
    case CellType::tet10:
      return tet10;
    case CellType::hex20:
    case CellType::hex27:
      return std::span(hex27).first(n);
    case CellType::wedge6:
    case CellType::wedge15:
      return std::span(wedge15).first(n);
    default:
      return std::span(same).first(n);
  }
}

}  // namespace creepcontact::io
