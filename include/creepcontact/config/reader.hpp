#pragma once
/// Reads a configuration: TOML, overrides from the command line, every check that needs no mesh.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// @param file       TOML 1.0; relative paths inside are taken relative to its directory
/// @param overrides  "key.path=value"; array entries by index ("contacts.0.gap=-0.1"); a value that is no TOML value is
///                   a string
/// @throws ConfigError holding every mistake found, one a line:
///         "file:line:column: key.path: what was found; what is allowed; did you mean 'x'?"
Config read(const std::filesystem::path& file, const Vocabulary& vocabulary,
            const std::vector<std::string>& overrides = {});

/// As read(), from text. @param file  stands in messages; relative paths are taken relative to its directory
Config parse(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
             const std::vector<std::string>& overrides = {});

}  // namespace creepcontact::config
