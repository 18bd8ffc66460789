#pragma once
/// Nodes of a document as text.

#include <toml++/toml.h>

#include <functional>
#include <string>
#include <string_view>

namespace creepcontact::config {

/// A name that needs quotation marks in a path gets them; a path with marks of its own keeps those.
std::string path_part(std::string_view key);

/// As toml++ prints a node that is neither a list nor a table.
std::string printed(const toml::node& leaf);

/// In one line; tables sorted by key.
/// @param leaf_text  of what is neither a list nor a table
std::string toml_text(const toml::node& node, const std::function<std::string(const toml::node&)>& leaf_text);

}  // namespace creepcontact::config
