#pragma once
/// Which dimension each number of [materials.<name>] has, and its conversion to other units.

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "creepcontact/config/vocabulary.hpp"
#include "unit_conversion.hpp"
#include "value.hpp"

namespace creepcontact::config {

/// Converts the tables of a material from one set of units to another; where they are the same, nothing changes.
class MaterialUnits {
 public:
  /// @param from, to  as `units` of a configuration @throws std::invalid_argument for units that are not understood
  MaterialUnits(const std::string& from, const std::string& to, const Vocabulary& vocabulary);

  /// The elastic constants and the expansion of a material, not its blocks.
  void convert_properties(toml::table& material) const;
  /// A block of creep, with the ranges of its data; the law's defaults that depend on units are written into it.
  void convert_creep(toml::table& block) const;
  void convert_rupture(toml::table& block) const;
  void convert_fatigue(toml::table& block) const;
  void convert_plasticity(toml::table& block) const;
  /// All of it, creep blocks with units of their own excepted.
  void convert_material(toml::table& material) const;

 private:
  MaterialUnits(const UnitChange& change, const Vocabulary& vocabulary);

  UnitConversion conversion_;
  bool same_;
  const Vocabulary& vocabulary_;
};

/// Keys that convert_properties() converts.
std::vector<std::string> converted_properties();

/// Replaces the key `units` of a material and of its creep blocks by the conversion of their numbers.
/// @param item  the material @param units  of the model; empty: not known, and the numbers and `units` stay
void apply_own_units(const Item& item, toml::table& material, const std::string& units, const Vocabulary& vocabulary,
                     Diagnostics& errors);

}  // namespace creepcontact::config
