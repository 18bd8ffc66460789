#pragma once
/// Words that users of other programs write, and keys of features that this version does not have.

#include <span>
#include <string>
#include <string_view>

namespace creepcontact::config {

struct KnownWord {
  std::string_view place;  ///< the table, "contacts[]", or the key whose value it is, "contacts[].type="
  std::string_view words;  ///< in small letters, separated by spaces
  std::string_view says;   ///< names the right 'key', or begins with absent_feature
};

inline constexpr std::string_view absent_feature = "not in this version";

/// All of them, keys and values.
std::span<const KnownWord> known_words();

/// What to say of an unknown key; empty if the word is not known. @param key  with indices and names of the user's
std::string said_of_key(const std::string& key, std::string_view word);
/// What to say of an unknown value of a key.
std::string said_of_value(const std::string& key, std::string_view word);
/// Explains a word that may belong to any table, as after `list keys`, with its place in front.
std::string said_of_word(std::string_view word);

}  // namespace creepcontact::config
