#pragma once
/// Names that the configuration may use and other modules define; the caller of the reader passes them in.

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/unit_powers.hpp"

namespace creepcontact::config {

/// One key of a creep law.
struct LawKey {
  std::string name;
  std::string description;
  double minimum = 0;                   ///< smallest allowed value ...
  bool strict = true;                   ///< ... exclusive
  bool list = false;                    ///< true: takes a list of values; all lists of a law have the same length
  bool required = true;                 ///< false: `fallback` if not given
  std::vector<Function> fallback = {};  ///< may be empty: then there is no value
  std::vector<std::string> variables = {"T"};                ///< allowed in its expressions
  double maximum = std::numeric_limits<double>::infinity();  ///< largest allowed value, inclusive
  /// Not empty: the value is one of these words; as a Function, its number, from 0 on.
  std::vector<std::string> words = {};
  UnitPowers dimension = unit::none;  ///< exponents that are constants: by their places in Law::keys
};

/// A value that is in the range of its key but not possible for the law.
struct LawError {
  std::string key, found, allowed;
};

/// Result of the check of a law's values.
struct LawValidation {
  std::optional<LawError> mistake;
  bool depends_on_temperature = false;
};

/// A creep law that a configuration may name.
struct Law {
  std::string name;
  std::vector<LawKey> keys;
  /// Argument: the values per key, in order. An empty function means that no validation is needed.
  std::function<LawValidation(const std::vector<std::vector<Function>>&)> validate = {};
  std::string formula = {};  ///< one line, for display
};

/// A quantity of probes.
struct Quantity {
  std::string name;
  bool surface_only = false;  ///< not defined at a point or over a body
  bool body_only = false;     ///< one value per body (and plane)
  bool sum_only = false;      ///< area, force: only reduce = "sum" is meaningful
  bool cylindrical = false;   ///< component about an axis that the probe may give
  bool moment = false;        ///< about a point that the probe may give
  bool section = false;       ///< of a plane through a body
};

/// All names known to the program; made by run::vocabulary().
struct Vocabulary {
  std::vector<Law> laws;
  std::vector<std::string> integrators;
  std::map<std::string, std::vector<std::string>> tables;  ///< by integrator: allowed Butcher tables
  std::vector<Quantity> quantities;
  /// Checks Larson-Miller data; nullopt: valid.
  std::function<std::optional<LawError>(const std::vector<double>& stress, const std::vector<double>& parameter)>
      validate_larson_miller = {};
  /// Checks a fatigue curve, unless it has no points, and the points of an interaction diagram; nullopt: valid.
  std::function<std::optional<LawError>(const std::vector<double>& strain_range, const std::vector<double>& cycles,
                                        const std::vector<std::vector<double>>& interaction)>
      validate_fatigue = {};
  std::filesystem::path materials = {};  ///< directory of the material library; empty: there is none
};

}  // namespace creepcontact::config
