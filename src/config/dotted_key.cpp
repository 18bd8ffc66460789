#include "creepcontact/config/dotted_key.hpp"

namespace creepcontact::config {

std::string with_dots(const std::string& key) {
  std::string dotted;
  bool is_quoted = false;
  for (const char letter : key) {
    is_quoted ^= letter == '"';
    if (is_quoted || (letter != '[' && letter != ']'))
      dotted += letter;
    else if (letter == '[')
      dotted += '.';
  }
  return dotted;
}

}  // namespace creepcontact::config
