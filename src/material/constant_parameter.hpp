#pragma once
/// Parameters that are numbers, not functions of the temperature.

#include <limits>

#include "creepcontact/base/function.hpp"

namespace creepcontact::material {

/// @returns the number
/// @throws ParameterError if it is a function, no number, or not in (above, most]
double require_constant(const char* key, const Function& value, double above,
                        double most = std::numeric_limits<double>::infinity());

}  // namespace creepcontact::material
