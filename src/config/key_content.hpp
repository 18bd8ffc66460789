#pragma once
/// What a configuration has under a key, before it is read.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

struct KeyContent {
  enum class Kind { absent, number, other };
  Kind kind = Kind::absent;
  double number = 0;
  std::string description = {};  ///< "string 'abc'"
};

/// The contents of several keys, written as for --set, with the data of the material library and the overrides.
/// @throws ConfigError if the file is not TOML, or the overrides or the data cannot be placed
std::vector<KeyContent> contents_of(const std::filesystem::path& file, const Vocabulary& vocabulary,
                                    const std::vector<std::string>& overrides, const std::vector<std::string>& keys);

}  // namespace creepcontact::config
