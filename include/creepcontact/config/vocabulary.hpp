#pragma once
/// Names that the configuration may use but other modules define; the caller of the reader passes them in.

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::config {

struct LawKey {
  std::string name;
  std::string description;
  double minimum = 0;                          ///< smallest admissible value ...
  bool strict = true;                          ///< ... exclusive
  bool list = false;                           ///< takes a list of values; the lists of a law have the same length
  bool required = true;                        ///< if not: `fallback` when not given
  std::vector<Function> fallback = {};         ///< may be empty: not given
  std::vector<std::string> variables = {"T"};  ///< that its expressions may use
  double maximum = std::numeric_limits<double>::infinity();  ///< largest admissible value, inclusive
};

/// A value that the law cannot have.
struct LawMistake {
  std::string key, found, allowed;
};

/// What the law itself says of its values, those of the keys in their order.
struct LawVerdict {
  std::optional<LawMistake> mistake;
  bool depends_on_temperature = false;
};

struct Law {
  std::string name;
  std::vector<LawKey> keys;
  std::function<LawVerdict(const std::vector<std::vector<Function>>&)> judge = {};
  std::string formula = {};  ///< what the law is, in one line
};

struct Quantity {
  std::string name;
  bool surface_only = false;  ///< has no meaning at a point or over a body
  bool sum_only = false;      ///< area, force: only reduce = "sum" has a meaning
  bool cylindrical = false;   ///< a component about an axis, which the probe may name
};

struct Vocabulary {
  std::vector<Law> laws;
  std::vector<std::string> integrators;
  std::map<std::string, std::vector<std::string>> tables;  ///< Butcher tables, of the integrators that let one choose
  std::vector<Quantity> quantities;
  /// What is wrong with Larson-Miller data, if anything is.
  std::function<std::optional<LawMistake>(const std::vector<double>& stress, const std::vector<double>& parameter)>
      judge_larson_miller = {};
};

}  // namespace creepcontact::config
