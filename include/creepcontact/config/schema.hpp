#pragma once
/// The keys of configurations and studies as data: what the readers accept is what this lists.

#include <string>
#include <vector>

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// How a key is written.
enum class Form {
  value,   ///< key = ...; keys below it stand among those of its table: rotation.axis
  table,   ///< [time]
  tables,  ///< [[contacts]]
  named,   ///< [bodies.<name>]
};

/// A word that a key may be.
struct Word {
  std::string text;
  std::string meaning = {};
};

/// Texts for people have code in `backquotes`.
struct KeyInfo {
  std::string path;  ///< "time.end"; <name> stands for a name of the user's, [] for every entry of a list
  std::string type;  ///< what is allowed, for messages: "a number > 0"
  bool required = false;
  std::string default_value;  ///< as it would be written; empty if required or absent by default
  std::string description;
  std::string otherwise = {};  ///< what holds where there is neither a default to be written nor a value
  std::string brief = {};      ///< the type, for tables: "number > 0"
  Form form = Form::value;
  std::vector<Word> words = {};  ///< that it may be; among other things if the type says so
  std::string only_with = {};    ///< word of the key before that these stand with: a creep law
};

/// All keys of a configuration, in the order of the tables; a table comes before its keys.
std::vector<KeyInfo> schema(const Vocabulary& vocabulary);
/// All keys of a study.
std::vector<KeyInfo> study_schema();

}  // namespace creepcontact::config
