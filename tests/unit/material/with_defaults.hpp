#pragma once
/// Values of the constants of creep laws.

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// One value per constant.
inline ParameterValues single_values(const std::vector<double>& numbers) {
  ParameterValues values;
  for (const double number : numbers) values.push_back({number});
  return values;
}

/// A creep law made as from a configuration that gives its first keys. @param values  of the first keys; the others
/// have their defaults
inline std::unique_ptr<CreepLaw> make_law(const std::string& name, ParameterValues values) {
  const LawInfo* info = find_creep_law(name);
  for (std::size_t i = values.size(); i < info->parameters.size(); ++i)
    values.push_back(info->parameters[i].fallback.value());
  return info->make(std::move(values));
}

}  // namespace creepcontact::material
