#pragma once
/// Registry of the creep laws: which names a configuration may use, and how each law is made.

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// One key of a law in the configuration.
struct ParameterInfo {
  std::string key;          ///< as in the configuration
  std::string description;  ///< with its unit in terms of stress and time
  double minimum = 0;       ///< smallest allowed value ...
  bool strict = true;       ///< ... exclusive
  bool list = false;        ///< true: takes a list of values; all lists of a law have the same length
  std::optional<std::vector<Function>> fallback = {};        ///< of an optional key: its value if not given
  std::vector<std::string> variables = {"T"};                ///< allowed in its expressions
  double maximum = std::numeric_limits<double>::infinity();  ///< largest allowed value, inclusive
  /// Not empty: the value is one of these words, and the number of the word in ParameterValues, from 0 on.
  std::vector<std::string> words = {};
};

/// Thrown for values that are within their ranges but not possible for the law.
class ParameterError : public std::invalid_argument {
 public:
  /// @param found  description of the value
  /// @param allowed  description of the allowed values
  ParameterError(std::string key, std::string found, std::string allowed)
      : std::invalid_argument(key + ": " + found + "; allowed: " + allowed),
        key_(std::move(key)),
        found_(std::move(found)),
        allowed_(std::move(allowed)) {}
  const std::string& key() const { return key_; }
  const std::string& found() const { return found_; }
  const std::string& allowed() const { return allowed_; }

 private:
  std::string key_, found_, allowed_;
};

/// Values per key, in the order of LawInfo::parameters; one value each, or several for a list.
using ParameterValues = std::vector<std::vector<Function>>;

/// One creep law that a configuration may name.
struct LawInfo {
  std::string name;
  std::string formula;  ///< one line, plain text
  std::string source;   ///< author, year
  std::vector<ParameterInfo> parameters;
  /// @throws ParameterError if the law cannot have these values
  std::unique_ptr<CreepLaw> (*make)(ParameterValues values);
  std::vector<const StateVariable*> state_variables = {};  ///< that its laws may have
};

/// All laws.
const std::vector<LawInfo>& creep_laws();
/// @returns nullptr if the name is unknown
const LawInfo* find_creep_law(const std::string& name);

}  // namespace creepcontact::material
