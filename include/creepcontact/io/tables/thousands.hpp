#pragma once
/// What separates thousands in the numbers of a table.

#include <optional>
#include <string>
#include <string_view>

namespace creepcontact::io {

enum class Thousands { none, point, comma, blank, apostrophe };

/// The separator with this sign: ".", ",", " " or an apostrophe; nullopt: none of these.
std::optional<Thousands> thousands_named(std::string_view name);

/// The number without its thousands separators, with a decimal point; nullopt if they are not between groups of three
/// digits.
std::optional<std::string> without_thousands(std::string_view number, Thousands thousands);

}  // namespace creepcontact::io
