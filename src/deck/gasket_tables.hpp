#pragma once
/// [gaskets.<name>] of decks.

#include "draft.hpp"
#include "gasket_layers.hpp"

namespace creepcontact::deck {

/// Returns a name as a key can have it, which no gasket has yet.
std::string name_of_gasket(const Draft& draft, const std::string& wanted);
/// Makes the gasket of a layer, or finds it if there is the same one already.
/// @returns its name; empty, with a reason in draft.impossible, if it cannot be
std::string make_gasket(Draft& draft, const GasketLayer& layer);

}  // namespace creepcontact::deck
