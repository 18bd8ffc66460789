#pragma once
/// Registry of the creep laws: which names a configuration may use, and how each law is made.

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "creepcontact/base/unit_powers.hpp"
#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

/// How a constant depends on the temperature through an activation energy E: f = exp(-E/(R (T - absolute_zero))).
enum class Activation {
  none,
  rate,   ///< f multiplies the constant
  time,   ///< f divides the constant: a time or a viscosity
  by_law  ///< f multiplies the constant, but the law does so itself
};

/// One key of a law in the configuration.
struct ParameterInfo {
  std::string key;          ///< as in the configuration
  std::string description;  ///< with its unit in terms of stress and time
  UnitPowers dimension;     ///< exponents that are constants: by their places in LawInfo::parameters
  double minimum = 0;       ///< smallest allowed value ...
  bool strict = true;       ///< ... exclusive
  bool list = false;        ///< true: takes a list of values; all lists of a law have the same length
  std::optional<std::vector<Function>> fallback = {};        ///< of an optional key: its value if not given
  std::vector<std::string> variables = {"T"};                ///< allowed in its expressions
  double maximum = std::numeric_limits<double>::infinity();  ///< largest allowed value, inclusive
  /// If not empty, the value is one of these words, and ParameterValues has the number of the word, from 0 on.
  std::vector<std::string> words = {};
  Activation activation = Activation::none;
  /// Position of the activation energy E in LawInfo::parameters; rows that do not give it have `activation_energy`.
  std::optional<std::size_t> energy = {};
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

/// One creep law that a configuration may name.
struct LawInfo {
  std::string name;
  std::string formula;  ///< one line, plain text
  std::string source;   ///< author, year
  /// Indexed by the enumeration of the law's constants; the keys of thermal activation follow, if it has them.
  std::vector<ParameterInfo> parameters;
  /// Constructs the law from values that are activated already; make() is for callers.
  std::unique_ptr<CreepLaw> (*construct)(const ParameterValues& values);
  std::vector<const StateVariable*> state_variables = {};  ///< that its laws may have

  /// Makes the law. @param values  indexed like `parameters`; those with an activation become functions of T
  /// @throws ParameterError if the law cannot have these values
  /// @throws std::out_of_range if their number is not that of the parameters
  std::unique_ptr<CreepLaw> make(ParameterValues values) const;
  /// Makes the law from values by key; keys that are not given have their fallback.
  /// @throws ParameterError also if a required key is missing, or if the law has no such key
  std::unique_ptr<CreepLaw> make_by_key(const std::map<std::string, std::vector<Function>>& given) const;
  /// True if the parameter is the activation energy of another one.
  bool is_activation_energy(std::size_t parameter) const;
};

/// All laws.
const std::vector<LawInfo>& creep_laws();
/// @returns nullptr if the name is unknown
const LawInfo* find_creep_law(const std::string& name);

}  // namespace creepcontact::material
