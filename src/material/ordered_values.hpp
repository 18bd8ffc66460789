#pragma once
/// Points of tables.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// Requires finite values in increasing or decreasing order. @param allowed  in the error of a value that violates this
/// @throws ParameterError
inline void require_order(const char* key, const std::vector<double>& values, bool increasing,
                          const std::string& allowed = "values that increase") {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) throw ParameterError(key, fmt::format("the number {}", values[i]), "finite numbers");
    if (i > 0 && (increasing ? !(values[i] > values[i - 1]) : !(values[i] < values[i - 1])))
      throw ParameterError(key, fmt::format("{} after {}", values[i], values[i - 1]), allowed);
  }
}

}  // namespace creepcontact::material
