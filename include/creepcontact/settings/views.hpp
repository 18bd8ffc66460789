#pragma once
/// Directions from which pictures show solids.

#include <array>
#include <string_view>

namespace creepcontact::settings {

constexpr std::array<std::string_view, 7> views{"iso", "x", "-x", "y", "-y", "z", "-z"};

}  // namespace creepcontact::settings
