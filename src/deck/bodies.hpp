#pragma once
/// Bodies of a deck: elements that share nodes, split by the material and the axes of their sections, and by sources of
/// heat.

#include <string>
#include <vector>

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

struct DeckBody {
  std::string name;      ///< of an element set that holds these elements alone, or of its section
  std::string material;  ///< in upper case
  double thickness = 1;
  Numbers elements;         ///< ascending
  std::string orientation;  ///< of a material with axes, in upper case; empty: x, y, z
  Place section;
};

struct Bodies {
  std::vector<DeckBody> bodies;
  bool share_nodes = false;  ///< two materials meet at nodes
};

/// @param impossible  gets elements without a section, and sections whose material is not defined
Bodies find_bodies(const Deck& deck, std::vector<Note>& impossible);

}  // namespace creepcontact::deck
