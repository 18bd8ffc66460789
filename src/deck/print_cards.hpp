#pragma once
/// *NODE PRINT and *EL PRINT.

#include <string>

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// Whether a card prints a variable. @param what  in upper case
bool asks_for(const RawCard& raw, const std::string& what);

}  // namespace creepcontact::deck
