#pragma once
/// The constants of a law as a table with one row per enumerator.

#include <array>
#include <type_traits>
#include <utility>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {

/// Row of a constant. @tparam constant  enumerator of the law's constants
template <auto constant>
struct Row {
  ParameterInfo info;
};

/// True if these are all enumerators of a law's constants in their order; the last enumerator, which counts them, is
/// n_constants.
template <auto... constants>
concept AllConstantsInOrder = [] {
  constexpr std::array places{static_cast<std::size_t>(constants)...};
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i] != i) return false;
  return places.size() == static_cast<std::size_t>(std::common_type_t<decltype(constants)...>::n_constants);
}();

/// The table of a law. It does not compile if a constant has no row, or if the rows have another order than the
/// enumeration.
template <auto... constants>
requires AllConstantsInOrder<constants...> std::vector<ParameterInfo> law_table(Row<constants>... rows) {
  return {std::move(rows.info)...};
}

/// The row of an exponent of the stress.
inline ParameterInfo stress_exponent(const char* key = "n", const char* description = "stress exponent [-]") {
  return {.key = key, .description = description, .dimension = unit::none, .minimum = 1.0, .strict = false};
}

/// The first n of the values: the constants that a law evaluates at points.
inline ParameterValues first(const ParameterValues& values, std::size_t n) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n)};
}

/// LawInfo::construct of a law whose constructor takes all values.
template <class Law>
std::unique_ptr<CreepLaw> construct(const ParameterValues& values) {
  return std::make_unique<Law>(values);
}

}  // namespace creepcontact::material
