#pragma once
/// What a configuration may name, for people.

#include <string>

namespace creepcontact::run {

/// A table for a terminal. @param what  integrators, laws, elements or quantities
/// @throws ConfigError for anything else
std::string list(const std::string& what);

/// The same for documents; the laws with all their keys.
std::string list_markdown(const std::string& what);

}  // namespace creepcontact::run
