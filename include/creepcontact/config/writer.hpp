#pragma once
/// Configurations that are made in code: what the reader of files adds to them, and how they are written as TOML.

#include <map>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// Adds what follows from other keys: names of contacts, the directory of results, reductions of areas and forces, and
/// constants of laws that are not given, in the order of the law. The output times get 0, the end and the times of
/// fields. In axisymmetric models y replaces the axis [0, 0, 1], the default. Changes nothing in a configuration that
/// is complete, as those that have been read are.
/// @throws std::invalid_argument for a law that the vocabulary does not have, or a constant that its law does not have
void complete(Config& config, const Vocabulary& vocabulary);
/// A completed copy. @throws as complete()
Config completed(Config config, const Vocabulary& vocabulary);

/// Comments of a file, without "#", by the full key of a value ("contacts[0].gap") or of a table ("contacts[0]").
struct Comments {
  std::map<std::string, std::string> beside;  ///< at the end of the line
  std::map<std::string, std::string> above;   ///< lines of their own; of an empty key: at the top of the file
};

/// Text of which the reader makes an equal configuration. Keys that have their defaults are left out, unless they have
/// a comment. Paths are relative to the directory of Config::file. What only the command line sets
/// (Mesh::trust_geometry) is not in it.
/// @param config  complete
std::string to_toml(const Config& config, const Vocabulary& vocabulary, const Comments& comments = {});

}  // namespace creepcontact::config
