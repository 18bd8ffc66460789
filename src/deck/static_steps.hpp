#pragma once
/// The time that *STATIC steps take in a run with *VISCO steps.

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// Returns a time so short that next to nothing creeps in it; 0 if they need none. That is so in two cases: no material
/// of a body yields and no contact has friction, so that the last loads before a *VISCO step alone count; or the first
/// step alone is *STATIC and what it brings on lasts. Its loads grow in proportion then, as those of t = 0 do. Bolts
/// that are held while other loads come need one too.
/// Precondition: the deck has *VISCO steps
double time_of_static_step(const Deck& deck);

}  // namespace creepcontact::deck
