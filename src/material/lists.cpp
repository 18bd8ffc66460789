#include "lists.hpp"

#include <fmt/format.h>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

void require_one_length(const std::vector<NamedList>& lists) {
  const auto& [first_key, first] = lists.front();
  for (const auto& [key, values] : lists) {
    if (values->empty()) throw ParameterError(key, "an empty list", "at least one value");
    if (values->size() != first->size())
      throw ParameterError(key, fmt::format("a list of {}", values->size()),
                           fmt::format("as many values as '{}' has: {}", first_key, first->size()));
  }
}

}  // namespace creepcontact::material
