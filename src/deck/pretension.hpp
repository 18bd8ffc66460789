#pragma once
/// *PRE-TENSION SECTION: cuts through bolts.

#include <utility>
#include <vector>

#include "linear_equations.hpp"

namespace creepcontact::deck {

/// A surface on which the deck's elements are separated. Its shortening, the same everywhere, is the first
/// displacement of the reference node; a force there is the tension of the bolt.
struct PretensionSection {
  std::int64_t reference = 0;
  Vector3 normal = Vector3::Zero();                          ///< of the shortening
  std::vector<std::pair<std::int64_t, std::int64_t>> nodes;  ///< of the surface's elements, and of the others
  std::vector<ElementFace> faces, opposite;                  ///< of these elements, and of the others
  Place place;
};

/// Gives the elements of each section's surface nodes of their own, which are new.
/// @param impossible  gets sections that are not surfaces within a body
std::vector<PretensionSection> cut_sections(Deck& deck, std::vector<Note>& impossible);

/// Both sides move alike, but for the shortening. @param n_components  2 in sections, 3 in solids
void append_equations(const PretensionSection& section, int n_components, std::vector<DeckEquation>& equations);

}  // namespace creepcontact::deck
