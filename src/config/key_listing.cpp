#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "creepcontact/config/key_reference.hpp"

namespace creepcontact::config {
namespace {

constexpr std::size_t line_length = 100;

/// Marks of code are for documents.
std::string plain(std::string text) {
  std::erase(text, '`');
  return text;
}

/// Lines that all begin in one column.
std::string wrapped(const std::string& text, std::size_t column) {
  std::istringstream words(text);
  std::string lines, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && column + line.size() + 1 + word.size() > line_length) {
      lines += line + '\n' + std::string(column, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + line + '\n';
}

std::string allowed(const KeyInfo& key) {
  std::string text = key.form == Form::value ? key.brief : key_sections({key}).back().title;
  if (!key.dimension.empty()) text += fmt::format(" [{}]", key.dimension);
  if (key.required) return text + "; required";
  if (!key.default_value.empty()) return text + "; default " + key.default_value;
  if (!key.otherwise.empty()) return text + "; not given: " + key.otherwise;
  return text;
}

}  // namespace

std::string key_listing(const std::vector<KeySection>& sections) {
  std::string text;
  for (const KeySection& section : sections) {
    if (!text.empty()) text += '\n';
    if (!section.title.empty())
      text +=
          fmt::format("{}  {}{}\n", section.title, plain(section.description), section.required ? "; required" : "");
    const auto label = [&](const KeyInfo& key) { return (key.only_with.empty() ? "  " : "    ") + section.name(key); };
    std::size_t width = 0;
    for (const KeyInfo& key : section.keys) width = std::max(width, label(key).size());
    const std::size_t column = width + 2;
    std::string law;
    for (const KeyInfo& key : section.keys) {
      if (key.only_with != law) text += fmt::format("  with \"{}\":\n", key.only_with);
      law = key.only_with;
      text += fmt::format("{:<{}}  {}", label(key), width, wrapped(plain(allowed(key)), column));
      text += std::string(column, ' ') + wrapped(plain(key.description), column);
    }
  }
  return text;
}

}  // namespace creepcontact::config
