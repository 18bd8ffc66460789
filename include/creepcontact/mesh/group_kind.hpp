#pragma once
/// Names of the dimensions of groups, for messages.

#include <array>
#include <cstddef>

namespace creepcontact::mesh {

/// "surface" for 2. @param dimension  0 to 3 @throws std::out_of_range for any other
constexpr const char* group_kind(int dimension) {
  constexpr std::array kinds{"point", "curve", "surface", "volume"};
  return kinds.at(static_cast<std::size_t>(dimension));
}

}  // namespace creepcontact::mesh
