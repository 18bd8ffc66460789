#pragma once
/// Decks that compute temperatures: [heat], what materials conduct, and what is left out where there is no mechanics.

#include "draft.hpp"

namespace creepcontact::deck {

/// In a deck without displacements takes supports, loads and constraints out. @param deck  gets a line that names them
void leave_out_mechanics(Deck& deck);
/// Sequences of steps of which one run cannot be made.
void refuse_steps_of_heat(Draft& draft);
/// @returns whether the material conducts; else the model is impossible
bool make_conduction(Draft& draft, const Material& material, config::Material& made);
/// [heat]
void make_heat(Draft& draft);

}  // namespace creepcontact::deck
