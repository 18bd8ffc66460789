#include "creepcontact/fem/reference_element.hpp"

#include <memory>
#include <stdexcept>

#include "polynomial_element.hpp"
#include "reference_nodes.hpp"

namespace creepcontact::fem {

namespace {

/// Volumes: the points that carry the creep state. Curves and surfaces: exact for N_i N_j times the element's own
/// (curved, polynomial) normal vector.
QuadratureRule load_rule(CellType type) {
  switch (type) {
    case CellType::line2:
      return gauss_line(2);
    case CellType::line3:
      return gauss_line(3);
    case CellType::tri3:
      return triangle(2);
    case CellType::tri6:
      return triangle(6);
    case CellType::quad4:
      return gauss_quadrilateral(2);
    case CellType::quad8:
    case CellType::quad9:
      return gauss_quadrilateral(4);
    case CellType::tet4:
      return tetrahedron(1);
    case CellType::tet10:
      return tetrahedron(3);  // rules of degree 2 fail the patch test on curved elements
    case CellType::hex8:
    case CellType::hex20:
      return gauss_hexahedron(2);
    case CellType::hex27:
      return gauss_hexahedron(3);
    case CellType::wedge6:
      return wedge(2, 2);
    case CellType::wedge15:
      return wedge(4, 2);
    case CellType::point1:
      break;
  }
  throw std::invalid_argument("no quadrature for a point");
}

/// The points that carry the creep state.
QuadratureRule bulk_rule(CellType type) {
  switch (type) {
    case CellType::tri3:
      return triangle(1);
    case CellType::tri6:
      return triangle(4);
    case CellType::quad8:
      return gauss_quadrilateral(2);
    case CellType::quad9:
      return gauss_quadrilateral(3);
    default:
      return load_rule(type);
  }
}

using Table = std::vector<std::unique_ptr<const ReferenceElement>>;  // null: a point

Table make_table() {
  Table table;
  for (const CellType type : mesh::cell_types())
    table.push_back(type == CellType::point1
                        ? nullptr
                        : std::make_unique<PolynomialElement>(type, reference_nodes(type), mesh::cell_faces(type),
                                                              load_rule(type), bulk_rule(type)));
  return table;
}

}  // namespace

const ReferenceElement& reference_element(CellType type) {
  static const Table table = make_table();
  const auto& element = table[static_cast<std::size_t>(type)];
  if (!element) throw std::invalid_argument("no reference element for a point");
  return *element;
}

const QuadratureRule& bulk_rule(CellType type, const mesh::Section& section) {
  const bool is_fine = section.is_axisymmetric() && type == CellType::quad8;
  return reference_element(is_fine ? CellType::quad9 : type).bulk_rule();
}

}  // namespace creepcontact::fem
