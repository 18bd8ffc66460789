#pragma once
/// Encodings of decks: names in configurations and meshes are UTF-8.

#include <string>
#include <string_view>

namespace creepcontact::deck {

/// Whether a text is UTF-8 (RFC 3629: without surrogates and overlong forms).
bool is_utf8(std::string_view text);
/// Each byte as the character with its number.
std::string utf8_of_latin1(std::string_view text);
/// UTF-8 without control characters: for comments and messages of one line.
std::string printable(std::string text);

}  // namespace creepcontact::deck
