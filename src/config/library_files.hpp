#pragma once
/// Files of the material library as documents.

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/material_library.hpp"

namespace creepcontact::config {

/// The names of the files without .toml, sorted.
std::vector<std::string> library_keys(const std::filesystem::path& directory);

/// @throws ConfigError for a file that cannot be read or lacks what every file needs
LibraryMaterial read_library_file(const std::filesystem::path& file);

/// The units of the numbers of a file, as `units` of a configuration; empty if one is missing.
std::string library_units(const toml::table& document);

}  // namespace creepcontact::config
