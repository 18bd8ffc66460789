#pragma once
/// Nodes at the same places that become one: of *TIE, and of *EQUATION between temperatures.

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// Makes one node of each two that a tie joins where all nodes of its slave surface lie on nodes of the master: the
/// mesh is then that of one body, without a tie. Takes these ties out of the deck; other ties stay.
void merge_matching_ties(Deck& deck);
/// In a deck without displacements makes one node of each two at one place whose temperatures an *EQUATION sets equal,
/// and takes these out of the deck; others stay.
void merge_equal_temperatures(Deck& deck);

}  // namespace creepcontact::deck
