#pragma once
/// Element types of decks: what they become, and the numbers of their nodes and faces.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/mesh/cell_type.hpp"
#include "creepcontact/settings/analysis.hpp"

namespace creepcontact::deck {

/// "C3D20R" is a C3D20: hex20, solid, with the variant R.
struct ElementType {
  std::string name;  ///< as written
  mesh::CellType cell{};
  settings::Analysis analysis{};  ///< of models of such elements
  std::string variant = {};  ///< letters after the number: R (reduced integration), H (hybrid), I (incompatible modes),
                             ///< T (with temperatures)
};

/// nullopt if the program has no such element: shells, beams, springs, fluids.
std::optional<ElementType> element_type(std::string_view name);

/// Returns the number of nodes of a shell, membrane, beam or truss; nullopt for another type.
std::optional<std::size_t> n_nodes_of_skin(std::string_view name);

/// A gasket element: its two sides, one opposite the other.
struct GasketShape {
  std::size_t n_nodes = 0;
  std::array<std::vector<int>, 2> corners;  ///< places (from 0) of the corners of SNEG, the lower side, and SPOS
  bool shears = true;                       ///< it has stiffness in shear too
};
/// Types of Abaqus: GK3D6, GK3D8, GK3D12M, GK3D18, GKAX4, GKPE4, GKPS4, each with N too. nullopt: another element.
std::optional<GasketShape> gasket_shape(std::string_view name);

/// Returns the node of the deck (from 0) that a type has at each place of the cell, in Gmsh's order.
const std::vector<int>& gmsh_order(mesh::CellType cell);

/// Face S1, S2, ... of an element: places of its corners, then of the nodes between them, in the order of the deck.
/// A face is an edge in sections. Faces of decks point outwards or inwards, as it happens.
/// @param number  from 1; nullptr if there is no such face
const std::vector<int>* face(mesh::CellType cell, int number);

}  // namespace creepcontact::deck
