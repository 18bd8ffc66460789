#pragma once
/// A value of the document together with its key and place.

#include <toml++/toml.h>

#include <string>
#include <string_view>

#include "creepcontact/config/location.hpp"

namespace creepcontact::config {

struct Item {
  const toml::node* node;
  Location location;

  /// The entry of a table or nullptr inside; the location is the table's if there is none.
  Item child(std::string_view key) const;
  Item element(std::size_t index) const;
  bool has(std::string_view key) const { return child(key).node != nullptr; }
};

/// Source path of an override's nodes, which have no line worth naming.
inline constexpr std::string_view override_prefix = "--set ";

/// @param fallback  for nodes without a source of their own
Location locate(const toml::source_region& source, const std::string& key, const Location& fallback);

/// "string 'abc'", "number 3", "a list", ...
std::string describe(const toml::node& node);

/// Returns a key as the schema writes it: "materials.steel.creep[0].law" -> "materials.<name>.creep[].law".
std::string schema_path(const std::string& key);

/// "runs[0].axes" -> "runs.axes", as in headings
std::string without_indices(const std::string& key);

std::string join_key(const std::string& parent, std::string_view key);

}  // namespace creepcontact::config
