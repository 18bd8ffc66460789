#include <algorithm>

#include "creepcontact/config/key_reference.hpp"

namespace creepcontact::config {
namespace {

/// Returns a path as headings have it, without the marks of lists.
std::string heading(std::string path) {
  for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]")) path.erase(at, 2);
  return path;
}

/// The section that a key with a heading of its own opens.
KeySection opened_by(const KeyInfo& key) {
  KeySection section{.title = {}, .path = {}, .description = key.description, .required = key.required, .keys = {}};
  switch (key.form) {
    case Form::table:
      section.title = '[' + heading(key.path) + ']';
      section.path = key.path + '.';
      break;
    case Form::tables:
      section.title = "[[" + heading(key.path) + "]]";
      section.path = key.path + "[].";
      break;
    case Form::named:
      section.title = '[' + heading(key.path) + ".<name>]";
      section.path = key.path + ".<name>.";
      break;
    case Form::value:
      break;
  }
  return section;
}

}  // namespace

std::vector<KeySection> key_sections(const std::vector<KeyInfo>& schema) {
  std::vector<KeySection> sections(1);
  for (const KeyInfo& key : schema) {
    // the innermost table comes last
    const auto home = std::find_if(sections.rbegin(), sections.rend(),
                                   [&](const KeySection& section) { return key.path.starts_with(section.path); });
    home->keys.push_back(key);
    if (key.form != Form::value) sections.push_back(opened_by(key));
  }
  return sections;
}

std::string key_names(const std::vector<KeySection>& sections) {
  std::vector<std::string> seen;
  std::string text;
  for (const KeySection& section : sections) {
    for (const KeyInfo& key : section.keys) {
      if (key.form != Form::value || std::find(seen.begin(), seen.end(), key.path) != seen.end()) continue;
      seen.push_back(key.path);
      text += key.path + '\n';
    }
  }
  return text;
}

std::string key_values(const std::vector<KeySection>& sections) {
  std::string text;
  for (const KeySection& section : sections) {
    for (const KeyInfo& key : section.keys)
      for (const Word& word : key.words) text += word.text + '\n';
  }
  return text;
}

}  // namespace creepcontact::config
