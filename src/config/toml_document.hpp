#pragma once
/// TOML files as documents; mistakes of their syntax with their place.

#include <toml++/toml.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "creepcontact/config/schema.hpp"

namespace creepcontact::config {

/// @throws ConfigError if the file cannot be read
std::string read_text(const std::filesystem::path& file);

/// @param file    named in messages
/// @param schema  asked for if there is a mistake: it tells how headings of tables are written
/// @throws ConfigError for a mistake of the syntax
toml::table parse_toml(const std::string& text, const std::filesystem::path& file,
                       const std::function<std::vector<KeyInfo>()>& schema);

}  // namespace creepcontact::config
