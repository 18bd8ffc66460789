#pragma once
/// Lists of the names that a configuration may use, for users.

#include <string>

namespace creepcontact::run {

/// Table for a terminal. @param what  integrators, laws, elements or quantities
/// @throws ConfigError for any other value
std::string list(const std::string& what);

/// List in Markdown; laws with all their keys.
std::string list_markdown(const std::string& what);

}  // namespace creepcontact::run
