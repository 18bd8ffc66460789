#pragma once
/// Notes on cards as lines for users.

#include <string>
#include <vector>

#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// "file:line: *CARD: consequence", the first place of what is said several times with the number of the others. What
/// is missing is one thing wherever it is named: its cards count together. Order: that of the first places
std::vector<std::string> lines_of_notes(const std::vector<Note>& notes);

}  // namespace creepcontact::deck
