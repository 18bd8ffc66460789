#pragma once
/// Physical dimensions, and their units as given by the words of `units` in the configuration.

#include <string>

namespace creepcontact {

enum class Dimension { none, time, length, area, force, moment, energy, stress, temperature };

/// @param name  as in the tables of keys and output variables: "stress"; unknown or empty: none
Dimension dimension_of(const std::string& name);

/// "stress"; "value" for none.
std::string name_of(Dimension dimension);

/// The unit of a dimension in a list such as "mm, N, MPa, h, degC"; empty if the list has none for it.
std::string unit_of(Dimension dimension, const std::string& units);

}  // namespace creepcontact
