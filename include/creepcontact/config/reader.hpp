#pragma once
/// Reads a configuration: TOML, overrides from the command line, and all checks that do not need the mesh.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// @param file  TOML 1.0; relative paths in it are relative to its directory
/// @param overrides  "key.path=value"; entries of arrays by index ("contacts.0.gap=-0.1"). A value that is not a TOML
/// value is taken as a string.
/// @throws ConfigError with one line per error found:
///        "file:line:column: key.path: what was found; what is allowed; did you mean 'x'?"
Config read(const std::filesystem::path& file, const Vocabulary& vocabulary,
            const std::vector<std::string>& overrides = {});

/// Like read(), from text. @param file  name for messages; relative paths are relative to its directory
Config parse(const std::string& text, const std::filesystem::path& file, const Vocabulary& vocabulary,
             const std::vector<std::string>& overrides = {});

}  // namespace creepcontact::config
