#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/config/key_reference.hpp"
#include "known_words.hpp"

namespace creepcontact::config {
namespace {

using Parts = std::vector<std::string>;

bool is_index(const std::string& part) {
  return std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Names of a path; indices and their brackets count for nothing.
Parts parts_of(const std::string& path) {
  Parts parts;
  std::string part;
  for (const char c : path + '.') {
    if (c != '.' && c != '[' && c != ']') {
      part += c;
    } else if (!is_index(part)) {
      parts.push_back(part);
      part.clear();
    } else {
      part.clear();
    }
  }
  return parts;
}

/// `<name>` is whatever the user calls it.
bool begins_with(const Parts& path, const Parts& wanted) {
  return wanted.size() <= path.size() &&
         std::equal(wanted.begin(), wanted.end(), path.begin(),
                    [](const std::string& a, const std::string& b) { return b == "<name>" || a == b; });
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

using Test = std::function<bool(const KeySection&, const KeyInfo&)>;

std::vector<KeySection> keep(const std::vector<KeySection>& sections, const Test& test) {
  std::vector<KeySection> kept;
  for (KeySection section : sections) {
    std::erase_if(section.keys, [&](const KeyInfo& key) { return !test(section, key); });
    if (!section.keys.empty()) kept.push_back(section);
  }
  return kept;
}

bool may_be(const KeyInfo& key, const std::string& text) {
  return std::any_of(key.words.begin(), key.words.end(), [&](const Word& word) { return word.text == text; });
}

std::string question_for(const std::vector<KeySection>& sections, const std::string& wanted) {
  std::vector<std::string> names;
  for (const KeySection& section : sections) {
    for (const KeyInfo& key : section.keys) {
      names.push_back(key.path);
      names.push_back(section.name(key));
    }
  }
  return did_you_mean(wanted, names);
}

}  // namespace

std::vector<KeySection> select_keys(const std::vector<KeySection>& sections, const std::string& wanted) {
  const Parts parts = parts_of(wanted);
  const std::string word = lower_case(wanted);
  const auto has_word = [&](const std::string& text) { return lower_case(text).find(word) != std::string::npos; };
  std::vector<Test> tests;
  if (wanted.starts_with('[')) {
    tests.emplace_back([&](const KeySection& section, const KeyInfo&) {
      const Parts title = parts_of(section.path);
      return title.size() == parts.size() && begins_with(title, parts);
    });
  } else {
    tests.emplace_back([&](const KeySection&, const KeyInfo& key) { return begins_with(parts_of(key.path), parts); });
    tests.emplace_back([&](const KeySection& section, const KeyInfo& key) {
      return has_word(section.name(key)) || key.only_with == word || may_be(key, word);
    });
    tests.emplace_back([&](const KeySection&, const KeyInfo& key) { return has_word(key.description); });
  }
  for (const Test& test : tests) {
    std::vector<KeySection> kept = keep(sections, test);
    if (!kept.empty() && !wanted.empty()) return kept;
  }
  const std::string familiar = said_of_word(wanted);
  throw ConfigError(fmt::format("list: no key has '{}' in its name or description{}", wanted,
                                familiar.empty() ? question_for(sections, wanted) : "; " + familiar));
}

}  // namespace creepcontact::config
