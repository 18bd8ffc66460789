#pragma once
/// Writes nodes of a document as text.

#include <toml++/toml.h>

#include <functional>
#include <string>
#include <string_view>

namespace creepcontact::config {

/// Gives a name the quotation marks that it needs in a path; a path with marks of its own keeps those.
std::string path_part(std::string_view key);

/// Returns a node that is not a table and not a list as toml++ prints it.
std::string printed(const toml::node& leaf);

/// Writes a node in one line, tables sorted by key.
/// @param leaf_text  text of a node that is not a table and not a list
std::string toml_text(const toml::node& node, const std::function<std::string(const toml::node&)>& leaf_text);

}  // namespace creepcontact::config
