#pragma once
/// Gasket elements of a deck as the faces of bodies between which they lie.

#include <array>
#include <string>
#include <vector>

#include "loading.hpp"

namespace creepcontact::deck {

/// The elements of one *GASKET SECTION.
struct GasketLayer {
  GasketSection section;
  std::array<std::vector<ElementFace>, 2> faces;  ///< of bodies, below (SNEG) and above (SPOS)
  std::size_t slave = 0;                          ///< the side whose faces have the area of the gasket
  double thickness = 0;                           ///< of the section or of the mesh, with gap and space
  std::string interaction;                        ///< of a *CONTACT PAIR that holds it; empty: there is none
  Numbers nodes;                                  ///< of its elements
  bool shears = false;                            ///< its elements have stiffness in shear too
};

/// Finds the faces on which gaskets lie: faces that have their nodes, or that *TIE or *CONTACT PAIR join with them.
/// Takes these ties and pairs, and the gasket elements, out of the deck.
/// @param impossible  gets gaskets that touch no body, that have no section, or whose area no side has
std::vector<GasketLayer> take_gaskets(Deck& deck, std::vector<Note>& impossible);

}  // namespace creepcontact::deck
