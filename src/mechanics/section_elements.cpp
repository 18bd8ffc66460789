/// The elements of sections.

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "element_loops.hpp"

namespace creepcontact::mechanics {
namespace {

using fem::Projection;
using mesh::CellType;
using settings::Analysis;

template <int n_nodes, int n_points, Projection projection, bool with_bubble>
std::unique_ptr<const ElementBlock> make_element(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes,
                                                 const mesh::Section& section, BlockStart start) {
  const auto make = [&]<Kinematics kinematics>() {
    // Nothing locks in plane stress.
    constexpr bool free_zz = kinematics == Kinematics::plane_stress;
    return std::make_unique<
        ElementLoops<n_nodes, n_points, free_zz ? Projection::none : projection, with_bubble && !free_zz, kinematics>>(
        cells, nodes, section, start);
  };
  switch (section.analysis) {
    case Analysis::axisymmetric:
      return make.template operator()<Kinematics::axisymmetric>();
    case Analysis::generalized_plane_strain:
      return make.template operator()<Kinematics::generalized>();
    case Analysis::plane_stress:
      return make.template operator()<Kinematics::plane_stress>();
    default:
      return make.template operator()<Kinematics::plane>();
  }
}

}  // namespace

std::unique_ptr<const ElementBlock> ElementBlock::make_of_section(const mesh::CellBlock& cells,
                                                                  const std::vector<Vector3>& nodes,
                                                                  const mesh::Section& section, BlockStart start) {
  switch (cells.type) {
    case CellType::tri3:
      return make_element<3, 1, Projection::none, false>(cells, nodes, section, start);
    case CellType::tri6:
      return make_element<6, 6, Projection::linear, true>(cells, nodes, section, start);
    case CellType::quad4:
      return make_element<4, 4, Projection::constant, false>(cells, nodes, section, start);
    case CellType::quad8:
      if (section.is_axisymmetric())  // see fem::bulk_rule()
        return std::make_unique<ElementLoops<8, 9, Projection::linear, false, Kinematics::axisymmetric>>(
            cells, nodes, section, start);
      return make_element<8, 4, Projection::linear, false>(cells, nodes, section, start);
    case CellType::quad9:
      return make_element<9, 9, Projection::linear, false>(cells, nodes, section, start);
    default:
      throw ModelError(fmt::format("cells of type {} are not surface elements", mesh::name(cells.type)));
  }
}

}  // namespace creepcontact::mechanics
