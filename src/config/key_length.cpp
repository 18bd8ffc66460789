#include "key_length.hpp"

#include <algorithm>

namespace creepcontact::config {
namespace {

constexpr int max_parts = 20;

/// The end of the string whose first quotation mark is at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char mark = text[begin];
  const bool escapes = mark == '"';
  const auto is_mark = [&](std::size_t i) { return i < text.size() && text[i] == mark; };
  const bool lines = is_mark(begin + 1) && is_mark(begin + 2);
  if (!lines && is_mark(begin + 1)) return begin + 2;  // empty
  for (std::size_t i = begin + (lines ? 3 : 1); i < text.size(); ++i) {
    if (escapes && text[i] == '\\') {
      ++i;
    } else if (!lines && (text[i] == mark || text[i] == '\n')) {
      return i + 1;
    } else if (lines && is_mark(i) && is_mark(i + 1) && is_mark(i + 2)) {
      i += 3;
      for (int inside = 0; inside < 2 && is_mark(i); ++inside) ++i;  // marks before the last three are text
      return i;
    }
  }
  return text.size();
}

}  // namespace

std::optional<std::size_t> find_long_key(std::string_view document) {
  int parts = 1;
  for (std::size_t i = 0; i < document.size();) {
    switch (document[i]) {
      case '#':
        i = std::min(document.find('\n', i), document.size());
        break;
      case '"':
      case '\'':
        i = end_of_string(document, i);
        break;
      case '.':
        if (++parts > max_parts) return i;
        ++i;
        break;
      case '=':
      case ',':
      case '[':
      case ']':
      case '{':
      case '}':
      case '\n':
        parts = 1;
        ++i;
        break;
      default:
        ++i;
    }
  }
  return std::nullopt;
}

}  // namespace creepcontact::config
