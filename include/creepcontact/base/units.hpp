#pragma once
/// Physical dimensions, and their units as given by the words of `units` in the configuration.

#include <optional>
#include <string>
#include <vector>

namespace creepcontact {

enum class Dimension { none, time, length, area, force, moment, energy, stress, temperature };

/// @param name  as in the tables of keys and output variables: "stress"; unknown or empty: none
Dimension dimension_of(const std::string& name);

/// "stress"; "value" for none.
std::string name_of(Dimension dimension);

/// A unit in terms of that of the SI (kelvin, second, metre, newton, pascal): factor * value + offset.
struct UnitScale {
  double factor = 1, offset = 0;
};

/// @param unit  a word as in `units`: "MPa" @returns nullopt if it is not a unit of this dimension
std::optional<UnitScale> unit_scale(Dimension dimension, const std::string& unit);

/// The words for units of a dimension; none for area, moment and energy, which follow from those of others.
std::vector<std::string> known_units(Dimension dimension);

/// The unit of a dimension in a list such as "mm, N, MPa, h, degC"; empty if the list has none for it.
std::string unit_of(Dimension dimension, const std::string& units);

/// "1.5 MPa" in four digits, or "1.5" if the list has no unit for it.
std::string with_unit(double value, Dimension dimension, const std::string& units);

}  // namespace creepcontact
