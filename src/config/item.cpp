#include "item.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace creepcontact::config {

Location locate(const toml::source_region& source, const std::string& key, const Location& fallback) {
  Location location = fallback;
  location.key = key;
  if (source.begin.line == 0) return location;
  location.file = source.path ? *source.path : std::string();
  const bool in_file = !location.file.starts_with(override_prefix);
  location.line = in_file ? static_cast<int>(source.begin.line) : 0;
  location.column = in_file ? static_cast<int>(source.begin.column) : 0;
  return location;
}

std::string join_key(const std::string& parent, std::string_view key) {
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

std::string schema_path(const std::string& key) {
  std::string path;
  for (std::size_t i = 0; i < key.size(); ++i) {
    path += key[i];
    if (key[i] == '[') i = std::min(key.find(']', i), key.size()) - 1;
  }
  for (const std::string_view tables : {"materials.", "bodies."})
    if (path.starts_with(tables)) {
      const std::size_t end = std::min(path.find('.', tables.size()), path.size());
      path.replace(tables.size(), end - tables.size(), "<name>");
    }
  return path;
}

std::string without_indices(const std::string& key) {
  std::string text;
  bool inside = false;
  for (const char letter : key) {
    if (letter == '[') inside = true;
    if (!inside) text += letter;
    if (letter == ']') inside = false;
  }
  return text;
}

Item Item::child(std::string_view key) const {
  const toml::table* table = node ? node->as_table() : nullptr;
  const toml::node* found = table ? table->get(key) : nullptr;
  const std::string path = join_key(location.key, key);
  return {found, locate(found ? found->source() : toml::source_region{}, path, location)};
}

Item Item::element(std::size_t index) const {
  const toml::node& found = *node->as_array()->get(index);
  return {&found, locate(found.source(), fmt::format("{}[{}]", location.key, index), location)};
}

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("string '{}'", text->get());
  if (const auto* integer = node.as_integer()) return fmt::format("number {}", integer->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("number {}", number->get());
  if (const auto* boolean = node.as_boolean()) return fmt::format("boolean {}", boolean->get());
  if (const auto* array = node.as_array()) {
    return array->empty() ? "an empty list" : fmt::format("a list of {}", array->size());
  }
  return node.is_table() ? "a table" : "a date or time";
}

}  // namespace creepcontact::config
