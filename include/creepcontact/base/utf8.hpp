#pragma once
/// Characters in text of any bytes.

#include <cstddef>
#include <string_view>

namespace creepcontact {

/// Number of bytes of the UTF-8 character at the beginning of a text; 0 if there is none (RFC 3629: no longer forms of
/// other characters, no halves of surrogate pairs), or the text is empty.
std::size_t utf8_length(std::string_view text);

/// Whether a byte continues a character that an earlier byte begins.
constexpr bool continues_utf8(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace creepcontact
