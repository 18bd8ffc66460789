#pragma once
/// The keys of configurations and studies as data. The readers accept exactly these.

#include <string>
#include <vector>

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// How a key is written.
enum class Form {
  value,   ///< key = ...; subkeys such as rotation.axis belong to the same table
  table,   ///< [time]
  tables,  ///< [[contacts]]
  named,   ///< [bodies.<name>]
};

/// A word that a key accepts.
struct Word {
  std::string text;
  std::string meaning = {};
};

/// Description of one key. Texts for users have code in `backquotes`.
struct KeyInfo {
  std::string path;  ///< "time.end"; <name> is a user-defined name, [] for every entry of a list
  std::string type;  ///< allowed values, for messages: "a number > 0"
  bool required = false;
  std::string default_value;  ///< as written in the file; empty if required or absent by default
  std::string description;
  std::string otherwise = {};  ///< what holds if there is neither a value nor a default that can be written
  std::string brief = {};      ///< short form of `type`, for tables: "number > 0"
  Form form = Form::value;
  std::vector<Word> words = {};  ///< that it accepts; other values too if `type` says so
  std::string only_with = {};    ///< key only with this word of the preceding key, e.g. a creep law
  std::string dimension = {};    ///< of its numbers: "stress", "length"; empty: none, or not fixed
  bool identifies_model = true;  ///< a run in which it differs cannot be resumed
};

/// All keys of a configuration in the order of the tables; each table precedes its keys.
std::vector<KeyInfo> schema(const Vocabulary& vocabulary);
/// All keys of a study.
std::vector<KeyInfo> study_schema();

/// Writes the keys as JSON Schema (draft 7), for editors: types, bounds, words, defaults and descriptions.
std::string json_schema(const Vocabulary& vocabulary);
std::string study_json_schema();

}  // namespace creepcontact::config
