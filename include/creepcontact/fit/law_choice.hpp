#pragma once
/// Which parameters of a law are fitted, and what the others are.

#include <map>
#include <string>
#include <vector>

#include "creepcontact/fit/test_data.hpp"
#include "creepcontact/material/registry.hpp"

namespace creepcontact::fit {

/// The wishes of the command line.
struct LawWishes {
  std::string law;
  std::vector<std::string> set;   ///< "key=value": held at this value
  std::vector<std::string> free;  ///< optional keys that are to be fitted too
};

/// A law whose parameters are fitted or held.
struct LawChoice {
  const material::LawInfo* info = nullptr;
  material::ParameterValues held;          ///< per key; those of fitted keys have no meaning
  std::vector<std::size_t> fitted;         ///< positions in info->parameters
  std::map<std::string, std::string> set;  ///< held by wish or by the unit of the temperature: key and value as TOML
  std::vector<std::string> notes;          ///< what was chosen without being asked for
  double temperature_at_zero = 0;          ///< absolute zero in the unit of the data

  const material::ParameterInfo& parameter(std::size_t i) const { return info->parameters[fitted[i]]; }
};

/// Fitted are the numbers that the law requires, and its activation energies if the data have several temperatures.
/// @throws ConfigError for an unknown law or key, a value that cannot be read or is out of its range, or a required
/// list without a value. Also if nothing is to be fitted, or the data do not fit the law: several temperatures with a
/// law that does not depend on temperature, or one stress with a law whose parameters need several
LawChoice choose_law(const LawWishes& wishes, const TestData& data);

}  // namespace creepcontact::fit
