#include "creepcontact/config/dotted_key.hpp"

#include <toml++/toml.h>

#include <algorithm>

namespace creepcontact::config {
namespace {

std::string without_leading_zeros(const std::string& index) {
  return index.substr(std::min(index.find_first_not_of('0'), index.size() - 1));
}

}  // namespace

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

std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts;
  try {
    const toml::table document = toml::parse(with_dots(key) + " = 0");
    for (const toml::table* table = &document; table != nullptr && table->size() == 1;) {
      const auto entry = table->begin();
      const std::string part(entry->first.str());
      const bool is_index = !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
      parts.push_back(is_index ? without_leading_zeros(part) : part);
      table = entry->second.as_table();
    }
  } catch (const toml::parse_error&) {
    parts.clear();
  }
  if (parts.empty()) parts.push_back(key);
  return parts;
}

bool is_within(const std::vector<std::string>& inner, const std::vector<std::string>& outer) {
  return inner.size() >= outer.size() && std::equal(outer.begin(), outer.end(), inner.begin());
}

}  // namespace creepcontact::config
