#pragma once
/// Parameters that are lists of one length.

#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::material {

using NamedList = std::pair<const char*, const std::vector<Function>*>;

/// @throws ParameterError that names the list which is empty or longer or shorter than the first
void require_one_length(const std::vector<NamedList>& lists);

}  // namespace creepcontact::material
