#pragma once
/// TOML files as documents; mistakes of their syntax with their place.

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace creepcontact::config {

/// @throws ConfigError if the file cannot be read
std::string read_text(const std::filesystem::path& file);

/// @param file  stands in messages. @throws ConfigError for a mistake of the syntax
toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

}  // namespace creepcontact::config
