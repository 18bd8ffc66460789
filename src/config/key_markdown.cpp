#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "creepcontact/config/key_reference.hpp"

namespace creepcontact::config {
namespace {

std::string cell(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '|' ? "\\|" : std::string(1, c);
  return safe;
}

/// The anchor that a heading gets.
std::string anchor(const std::string& title) {
  std::string text;
  for (const char c : title)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') text += c;
  return text;
}

std::string fallback(const KeyInfo& key) {
  if (key.required) return "*required*";
  return key.default_value.empty() ? key.otherwise : '`' + key.default_value + '`';
}

std::string type_of(const KeyInfo& key) {
  if (key.form == Form::value)
    return key.dimension.empty() ? key.brief : fmt::format("{} [{}]", key.brief, key.dimension);
  const std::string title = key_sections({key}).back().title;
  return fmt::format("[`{}`](#{})", title, anchor(title));
}

/// The key whose words decide which others there are.
const KeyInfo* chooser_of(const KeySection& section) {
  for (const KeyInfo& key : section.keys) {
    for (const Word& word : key.words) {
      const auto stands_with = [&](const KeyInfo& other) { return other.only_with == word.text; };
      if (std::any_of(section.keys.begin(), section.keys.end(), stands_with)) return &key;
    }
  }
  return nullptr;
}

/// A table of the keys that are allowed with each word, optional ones in brackets.
std::string variants(const KeySection& section, const KeyInfo& chooser) {
  std::string text =
      fmt::format("\n| `{}` | what | keys (optional ones in brackets) |\n|---|---|---|\n", section.name(chooser));
  for (const Word& word : chooser.words) {
    std::string needed, optional;
    for (const KeyInfo& key : section.keys) {
      if (key.only_with != word.text) continue;
      std::string& names = key.required ? needed : optional;
      names += fmt::format("{}`{}`", names.empty() ? "" : ", ", section.name(key));
    }
    if (!optional.empty()) optional = fmt::format("{}[{}]", needed.empty() ? "" : " ", optional);
    text += fmt::format("| `\"{}\"` | {} | {} |\n", word.text, cell(word.meaning), needed + optional);
  }
  return text;
}

}  // namespace

std::string key_markdown(const std::vector<KeySection>& sections, bool headings) {
  std::string text;
  for (const KeySection& section : sections) {
    if (!text.empty()) text += '\n';
    if (headings && !section.title.empty()) text += fmt::format("### `{}`\n\n", section.title);
    text += "| key | type | default | meaning |\n|---|---|---|---|\n";
    const KeyInfo* chooser = chooser_of(section);
    for (const KeyInfo& key : section.keys) {
      if (!key.only_with.empty() && chooser) continue;
      text += fmt::format("| `{}` | {} | {} | {} |\n", section.name(key), cell(type_of(key)), cell(fallback(key)),
                          cell(key.description));
    }
    if (chooser) text += variants(section, *chooser);
  }
  return text;
}

}  // namespace creepcontact::config
