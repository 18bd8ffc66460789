#include "creepcontact/base/one_line.hpp"

#include <cstddef>

#include "creepcontact/base/utf8.hpp"

namespace creepcontact {
namespace {

/// Also those of the second half of Latin-1 (C1), and the line ends of Unicode.
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7F;
  return (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0) || character == "\u2028" ||
         character == "\u2029";
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0)
      result += '?';
    else if (is_control(text.substr(i, length)))
      result += ' ';
    else
      result += text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return result;
}

}  // namespace creepcontact
