#pragma once
/// The keys of a schema for people and scripts, cut into the tables of the file.

#include <string>
#include <vector>

#include "creepcontact/config/schema.hpp"

namespace creepcontact::config {

/// The keys that stand in one table of the file.
struct KeySection {
  std::string title;  ///< as in the file: "[time]", "[[contacts]]"; empty: outside all tables
  std::string path;   ///< of its keys, up to their names: "time.", "contacts[]."
  std::string description;
  bool required = false;
  std::vector<KeyInfo> keys;

  /// Name of a key within the table: "end", "rotation.axis"
  std::string name(const KeyInfo& key) const { return key.path.substr(path.size()); }
};

/// In the order of the schema; every key once, a table also among the keys of the one around it.
std::vector<KeySection> key_sections(const std::vector<KeyInfo>& schema);

/// The keys that are meant by
/// - "[time]": the keys of this table; "[]": those outside all tables
/// - a path, of a user's names and with indices too ("materials.steel.creep[0]"): the key and all below it
/// - anything else: the keys with this in their name or as one of their words, or else in their description
/// @throws ConfigError, naming the nearest key, if there are none
std::vector<KeySection> select_keys(const std::vector<KeySection>& sections, const std::string& wanted);

/// For a terminal.
std::string key_listing(const std::vector<KeySection>& sections);
/// A table of every section. @param headings  above each
std::string key_markdown(const std::vector<KeySection>& sections, bool headings);
/// One path a line, each once; tables with a heading of their own are not among them.
std::string key_names(const std::vector<KeySection>& sections);
/// The words that the keys may be, one a line.
std::string key_values(const std::vector<KeySection>& sections);

}  // namespace creepcontact::config
