#pragma once
/// A creep law made as from a configuration that gives its first keys.

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// @param values  of the first keys; the others have their defaults
inline std::unique_ptr<CreepLaw> make_law(const std::string& name, ParameterValues values) {
  const LawInfo* info = find_creep_law(name);
  for (std::size_t i = values.size(); i < info->parameters.size(); ++i)
    values.push_back(info->parameters[i].fallback.value());
  return info->make(std::move(values));
}

}  // namespace creepcontact::material
