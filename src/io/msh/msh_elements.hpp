#pragma once
/// Gmsh's element types by their numbers.

#include <optional>
#include <string>

#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::io {

struct MshElement {
  std::string family;  ///< "Pyramid"
  int dimension = 0;
  int n_nodes = 0;
  std::optional<mesh::CellType> cell;  ///< nullopt: the program has no such element

  /// The name in Gmsh: "Pyramid 5"
  std::string name() const;
};

/// nullptr: not a number of Gmsh's, or an element without a fixed number of nodes (polygons, polyhedra).
const MshElement* msh_element(int type);

}  // namespace creepcontact::io
