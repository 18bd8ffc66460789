#pragma once
/// The creep laws by name: what a configuration may ask for, and how each is made.

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

struct ParameterInfo {
  std::string key;                                     ///< as in the configuration
  std::string description;                             ///< with units in terms of stress, time
  double minimum = 0;                                  ///< smallest admissible value ...
  bool strict = true;                                  ///< ... exclusive
  bool list = false;                                   ///< takes a list of values; all lists of a law are of one length
  std::optional<std::vector<Function>> fallback = {};  ///< of an optional key: what it is if not given
  std::vector<std::string> variables = {"T"};          ///< that its expressions may use
  double maximum = std::numeric_limits<double>::infinity();  ///< largest admissible value, inclusive
};

/// Values that a law cannot have, which their ranges alone do not show.
class ParameterError : public std::invalid_argument {
 public:
  /// @param found  what the value is
  /// @param allowed  what it may be
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

/// Values of a law's keys, in the order of LawInfo::parameters: one, or those of a list.
using ParameterValues = std::vector<std::vector<Function>>;

struct LawInfo {
  std::string name;
  std::string formula;  ///< one line, plain text
  std::string source;   ///< author, year
  std::vector<ParameterInfo> parameters;
  /// @throws ParameterError
  std::unique_ptr<CreepLaw> (*make)(ParameterValues values);
};

const std::vector<LawInfo>& creep_laws();
/// @returns nullptr if there is none of this name
const LawInfo* find_creep_law(const std::string& name);

}  // namespace creepcontact::material
