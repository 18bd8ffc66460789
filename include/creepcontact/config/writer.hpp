#pragma once
/// Writes a configuration as TOML.

#include <map>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// Comments of a file, without "#", by the full key of a value ("contacts[0].gap") or of a table ("contacts[0]").
struct Comments {
  std::map<std::string, std::string> beside;  ///< at the end of the line
  std::map<std::string, std::string> above;   ///< lines of their own; of an empty key: at the top of the file
};

/// A string in quotation marks.
std::string toml_string(const std::string& text);

/// Text of which the reader makes an equal configuration. Keys that have their defaults are left out, unless they have
/// a comment. Paths are relative to the directory of Config::file. What only the command line sets
/// (Mesh::trust_geometry) is not in it.
/// @param config  complete (complete.hpp)
std::string to_toml(const Config& config, const Vocabulary& vocabulary, const Comments& comments = {});

}  // namespace creepcontact::config
