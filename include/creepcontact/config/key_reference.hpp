#pragma once
/// The keys of a schema as reference for users and scripts, grouped by the tables of the file.

#include <string>
#include <vector>

#include "creepcontact/config/schema.hpp"

namespace creepcontact::config {

/// The keys of one table of the file.
struct KeySection {
  std::string title;  ///< as in the file: "[time]", "[[contacts]]"; empty: outside all tables
  std::string path;   ///< common beginning of the paths of its keys: "time.", "contacts[]."
  std::string description;
  bool required = false;
  std::vector<KeyInfo> keys;

  /// Name of a key within the table: "end", "rotation.axis".
  std::string name(const KeyInfo& key) const { return key.path.substr(path.size()); }
};

/// Sections in the order of the schema. Each key appears once; a table is also listed among the keys of its parent.
std::vector<KeySection> key_sections(const std::vector<KeyInfo>& schema);

/// Selects keys by
/// - "[time]": the keys of this table; "[]": those outside all tables
/// - a path, also with user-defined names and indices ("materials.steel.creep[0]"): this key and all below it
/// - anything else: the keys with this in their name or among their words; if none, in their description
/// @throws ConfigError suggesting the nearest key if nothing is found
std::vector<KeySection> select_keys(const std::vector<KeySection>& sections, const std::string& wanted);

/// Text for a terminal.
std::string key_listing(const std::vector<KeySection>& sections);
/// A Markdown table per section. @param headings  put a heading above each
std::string key_markdown(const std::vector<KeySection>& sections, bool headings);
/// One path per line, without repetition; tables with their own heading are left out.
std::string key_names(const std::vector<KeySection>& sections);
/// The words that the keys accept, one per line.
std::string key_values(const std::vector<KeySection>& sections);

}  // namespace creepcontact::config
