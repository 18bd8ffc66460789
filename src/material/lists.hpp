#pragma once
/// Parameters that are lists of one length.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact::material {

using NamedList = std::pair<const char*, const std::vector<Function>*>;

/// One after the other.
/// @throws ParameterError that names the list which is empty or longer or shorter than the first
std::vector<Function> joined(const std::vector<NamedList>& lists);

/// The values of one of the lists that joined() made. @param number  of the list @param length  of each
inline std::span<const double> list_of(std::span<const double> joined, std::size_t number, std::size_t length) {
  return joined.subspan(number * length, length);
}

}  // namespace creepcontact::material
