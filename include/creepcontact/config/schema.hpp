#pragma once
/// The keys of the configuration as data: what the reader accepts is what this lists.

#include <string>
#include <vector>

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

struct KeyInfo {
  std::string path;  ///< "time.end"; <name> stands for a name of the user's, [] for every entry of a list
  std::string type;  ///< what is allowed: "a number > 0"
  bool required = false;
  std::string default_value;  ///< as it would be written; empty if required or absent by default
  std::string description;
};

/// All keys, in the order of the tables; a table comes before its keys.
std::vector<KeyInfo> schema(const Vocabulary& vocabulary);

}  // namespace creepcontact::config
