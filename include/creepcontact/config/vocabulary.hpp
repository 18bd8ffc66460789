#pragma once
/// Names that the configuration may use but other modules define; the caller of the reader passes them in.

#include <map>
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
};

struct Law {
  std::string name;
  std::vector<LawKey> keys;
};

struct Quantity {
  std::string name;
  bool surface_only = false;  ///< has no meaning at a point or over a body
  bool sum_only = false;      ///< area, force: only reduce = "sum" has a meaning
};

struct Vocabulary {
  std::vector<Law> laws;
  std::vector<std::string> integrators;
  std::map<std::string, std::vector<std::string>> tables;  ///< Butcher tables, of the integrators that let one choose
  std::vector<Quantity> quantities;
};

}  // namespace creepcontact::config
