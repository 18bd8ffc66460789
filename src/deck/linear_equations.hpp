#pragma once
/// *EQUATION and *MPC as linear equations between displacements along x, y and z.

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "node_frames.hpp"

namespace creepcontact::deck {

/// Sum of coefficient times u(node, component) = value; components from 0.
struct DeckEquation {
  std::map<std::pair<std::int64_t, int>, double> terms;
  Course value;
  Place place;
  std::string card = {};
};

/// All *EQUATION and *MPC of a deck; nodes of plane and straight constraints as where they are in the mesh, for
/// displacements are small. @param impossible  gets those that are not linear, or not known
std::vector<DeckEquation> read_equations(const Deck& deck, const Resolver& resolver, const NodeFrames& frames,
                                         std::vector<Note>& impossible);

/// Takes the nodes that no element has out of the equations: what is prescribed there becomes a value, what is free is
/// eliminated, and a force there becomes forces at the nodes that it depends on.
/// @param used  nodes of elements, ascending
/// @param loading  supports and forces of the other nodes are taken out
void eliminate_reference_nodes(std::vector<DeckEquation>& equations, const Numbers& used, Loading& loading);

}  // namespace creepcontact::deck
