#pragma once
/// *TIE of surfaces whose nodes are at the same places.

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// Makes one node of each two that a tie joins where all nodes of its slave surface lie on nodes of the master: the
/// mesh is then that of one body, without a tie. Takes these ties out of the deck; other ties stay.
void merge_matching_ties(Deck& deck);

}  // namespace creepcontact::deck
