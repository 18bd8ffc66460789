#pragma once
/// Enumerations whose values the configuration names. Each declares its names once, next to itself, by a function
///   constexpr auto names_of(Colour) { return std::to_array<EnumName<Colour>>({{"red", Colour::red}, ...}); }
/// that argument-dependent lookup finds. Readers, lists of keys and reports take the names from it.

#include <array>
#include <string_view>

namespace creepcontact::settings {

template <typename Enum>
struct EnumName {
  std::string_view name;
  Enum value;
};

/// As the configuration writes it; empty for a value that has no name there.
template <typename Enum>
constexpr std::string_view name_of(Enum value) {
  for (const auto& [name, named] : names_of(value))
    if (named == value) return name;
  return {};
}

}  // namespace creepcontact::settings
