#pragma once
/// Ties of surfaces that do not face each other: of bodies that the deck lets overlap, such as a bolt in its thread.

#include "linear_equations.hpp"

namespace creepcontact::deck {

/// True if the outward normals of both surfaces point the same way, on average.
bool face_alike(const Deck& deck, const std::vector<ElementFace>& slave, const std::vector<ElementFace>& master);

/// Each node of the slave surface moves as the point of the master surface nearest to it, as in CalculiX.
/// @param tolerance  nodes farther away are left alone; nullopt: a fortieth of the size of the master's faces
/// @param n_components  2 in sections, 3 in solids
std::vector<DeckEquation> tie_nodes_to_faces(const Deck& deck, const std::vector<ElementFace>& slave,
                                             const std::vector<ElementFace>& master, std::optional<double> tolerance,
                                             int n_components, const Place& place);

}  // namespace creepcontact::deck
