#pragma once
/// The units of a set of data, as `units` in the configuration names them.

#include <string>
#include <vector>

#include "creepcontact/base/unit_powers.hpp"
#include "creepcontact/base/units.hpp"

namespace creepcontact {

/// Units in terms of those of the SI.
struct UnitSystem {
  double stress = 1, time = 1, length = 1;
  UnitScale temperature = {};
};

/// The words of a list of units, which commas, semicolons, blanks or hyphens separate.
std::vector<std::string> unit_words(const std::string& units);

/// What unit_system() takes, for messages.
std::string accepted_units();

/// @param text  units separated by commas, blanks or hyphens: "mm, N, MPa, h, degC". Stress and time are needed;
/// without a stress, force and length give it. Temperatures are in degrees Celsius and lengths in millimetres unless
/// the text names others. Units of mass are accepted and have no effect.
/// @throws std::invalid_argument for an unknown word, two units of one dimension, a missing one, or a stress
/// that is not force per area
UnitSystem unit_system(const std::string& text);

/// @returns what the change does to the numbers of a constant
UnitChange unit_change(const UnitSystem& from, const UnitSystem& to);

}  // namespace creepcontact
