#include "constant_parameter.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

double require_constant(const char* key, const Function& value, double above, double most) {
  const std::string allowed =
      std::isfinite(most) ? fmt::format("a number in ({}, {}]", above, most) : fmt::format("a number > {}", above);
  if (!value.is_constant()) throw ParameterError(key, fmt::format("the function {}", value.text()), allowed);
  const double number = value({});
  if (!(number > above && number <= most)) throw ParameterError(key, fmt::format("the number {}", number), allowed);
  return number;
}

}  // namespace creepcontact::material
