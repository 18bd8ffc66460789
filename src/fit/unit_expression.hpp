#pragma once
/// The unit of a parameter as its description gives it in brackets: "[1/(time stress^n)]", "[stress time^(1/n)]".

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace creepcontact::fit {

/// The text in the first brackets of a description; empty: there are none.
std::string unit_in(const std::string& description);

/// True if a word is part of the unit: uses(unit, "stress").
bool unit_uses(const std::string& unit, std::string_view word);

/// The value of a unit: a product of words with exponents, '/' before what divides, parentheses; "-" is 1.
/// @param value  of a word: a basic unit ("time") or a key of the law, in exponents; nullopt: unknown
/// @returns nullopt if the text is not such a product or has an unknown word
std::optional<double> unit_value(const std::string& unit,
                                 const std::function<std::optional<double>(const std::string&)>& value);

}  // namespace creepcontact::fit
