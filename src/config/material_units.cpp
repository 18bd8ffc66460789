#include "material_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "creepcontact/base/unit_system.hpp"

namespace creepcontact::config {
namespace {

using Dimensions = std::vector<std::pair<std::string, UnitPowers>>;

const Dimensions& property_dimensions() {
  static const Dimensions all{{"young_modulus", unit::stress},
                              {"poisson_ratio", unit::none},
                              {"thermal_expansion", unit::per_degree},
                              {"reference_temperature", unit::temperature}};
  return all;
}
/// `parameter` is a temperature times a logarithm; `time_unit` is the unit of the model in that of the data.
const Dimensions& rupture_dimensions() {
  static const Dimensions all{{"rupture_time", unit::time},
                              {"stress", unit::stress},
                              {"parameter", unit::degree},
                              {"absolute_zero", unit::temperature},
                              {"time_unit", unit::per_time}};
  return all;
}
const Dimensions& orthotropic_dimensions() {
  static const Dimensions all{{"young_moduli", unit::stress}, {"shear_moduli", unit::stress}};
  return all;
}
const Dimensions& data_range_dimensions() {
  static const Dimensions all{{"stress", unit::stress}, {"temperature", unit::temperature}, {"time", unit::time}};
  return all;
}
const Dimensions& fatigue_dimensions() {
  static const Dimensions all{{"cycles_to_failure", unit::none}};
  return all;
}
const Dimensions& range_dimensions() {
  static const Dimensions all{
      {"stress_range", unit::stress}, {"temperature_range", unit::temperature}, {"time_range", unit::time}};
  return all;
}

void convert(toml::table& table, const Dimensions& dimensions, const UnitConversion& units) {
  for (const auto& [key, dimension] : dimensions) units.replace(table, key, dimension);
}

/// The constants of a creep law, those that are not given with their defaults.
void convert_law(toml::table& block, const Law& law, const UnitConversion& units) {
  toml::array constants;
  for (const LawKey& key : law.keys) {
    if (const toml::node* given = block.get(key.name)) {
      constants.push_back(*given);
    } else if (!key.list && !key.fallback.empty() && key.fallback.front().is_constant()) {
      constants.push_back(key.fallback.front()({}));
    } else {
      constants.push_back(toml::array{});
    }
  }
  const auto value = [&](std::size_t place) { return constants.get(place); };
  for (std::size_t i = 0; i < law.keys.size(); ++i) {
    const LawKey& key = law.keys[i];
    if (!key.words.empty()) continue;
    if (block.contains(key.name)) {
      units.replace(block, key.name, key.dimension, value);
    } else if (const auto old = constants.get(i)->value<double>()) {
      toml::array box;
      units.append(*constants.get(i), key.dimension, value, box);
      if (box.get(0)->value<double>() != old) block.insert_or_assign(key.name, std::move(*box.get(0)));
    }
  }
}

bool is_none(const UnitChange& change) {
  return change.stress == 1 && change.time == 1 && change.length == 1 && change.degree == 1 && change.zero == 0;
}

}  // namespace

MaterialUnits::MaterialUnits(const std::string& from, const std::string& to, const Vocabulary& vocabulary)
    : MaterialUnits(unit_change(unit_system(from), unit_system(to)), vocabulary) {}

MaterialUnits::MaterialUnits(const UnitChange& change, const Vocabulary& vocabulary)
    : conversion_(change), same_(is_none(change)), vocabulary_(vocabulary) {}

std::vector<std::string> converted_properties() {
  std::vector<std::string> keys;
  for (const auto& [key, dimension] : property_dimensions()) keys.push_back(key);
  return keys;
}

void MaterialUnits::convert_properties(toml::table& material) const {
  if (!same_) convert(material, property_dimensions(), conversion_);
}

void MaterialUnits::convert_creep(toml::table& block) const {
  if (same_) return;
  convert(block, range_dimensions(), conversion_);
  const auto name = block["law"].value<std::string>();
  const auto law = std::ranges::find(vocabulary_.laws, name.value_or(""), &Law::name);
  if (law != vocabulary_.laws.end()) convert_law(block, *law, conversion_);
}

void MaterialUnits::convert_rupture(toml::table& block) const {
  if (same_) return;
  if (block.contains("stress")) {  // Larson-Miller data, with their defaults
    block.emplace("absolute_zero", Rupture{}.absolute_zero);
    block.emplace("time_unit", Rupture{}.time_unit);
  }
  convert(block, rupture_dimensions(), conversion_);
}

void MaterialUnits::convert_fatigue(toml::table& block) const {
  if (!same_) convert(block, fatigue_dimensions(), conversion_);
}

void MaterialUnits::convert_plasticity(toml::table& plasticity) const {
  for (const char* key : {"yield_stress", "hardening_modulus"}) conversion_.replace(plasticity, key, unit::stress);
  const auto convert_each = [&](const char* key, std::initializer_list<std::pair<const char*, UnitPowers>> dimensions) {
    const auto convert_one = [&](toml::node& node) {
      if (toml::table* one = node.as_table())
        for (const auto& [name, dimension] : dimensions) conversion_.replace(*one, name, dimension);
    };
    toml::node* node = plasticity.get(key);
    if (node == nullptr) return;
    if (toml::array* list = node->as_array())
      for (toml::node& one : *list) convert_one(one);
    else
      convert_one(*node);
  };
  convert_each("curve", {{"T", unit::temperature}, {"stress", unit::stress}});
  convert_each("kinematic", {{"C", unit::stress}});
}

void MaterialUnits::convert_material(toml::table& material) const {
  if (same_) return;
  convert_properties(material);
  if (toml::table* elastic = material["orthotropic"].as_table())
    convert(*elastic, orthotropic_dimensions(), conversion_);
  conversion_.replace(material, "yield_strength", unit::stress);
  if (toml::table* plasticity = material["plasticity"].as_table()) convert_plasticity(*plasticity);
  if (toml::table* range = material["data_range"].as_table()) convert(*range, data_range_dimensions(), conversion_);
  if (toml::table* rupture = material["rupture"].as_table()) convert_rupture(*rupture);
  if (toml::table* fatigue = material["fatigue"].as_table()) convert_fatigue(*fatigue);
  if (toml::array* creep = material["creep"].as_array())
    for (toml::node& block : *creep)
      if (toml::table* law = block.as_table(); law != nullptr && !law->contains("units")) convert_creep(*law);
}

void apply_own_units(const Item& item, toml::table& material, const std::string& units, const Vocabulary& vocabulary,
                     Diagnostics& errors) {
  const auto own_units = [&](const Item& table) -> std::optional<MaterialUnits> {
    const Item own = table.child("units");
    const auto text = own.node != nullptr ? own.node->value<std::string>() : std::nullopt;
    if (!text) return std::nullopt;
    try {
      unit_system(*text);
      return MaterialUnits(*text, units.empty() ? *text : units, vocabulary);
    } catch (const std::invalid_argument& error) {
      errors.add(own.location, error.what(), accepted_units());
      return std::nullopt;
    }
  };
  if (const auto conversion = own_units(item)) conversion->convert_material(material);
  if (!units.empty()) material.erase("units");
  toml::array* creep = material["creep"].as_array();
  for (std::size_t i = 0; creep != nullptr && i < creep->size(); ++i) {
    toml::table* block = creep->get(i)->as_table();
    if (block == nullptr) continue;
    if (const auto conversion = own_units(item.child("creep").element(i))) conversion->convert_creep(*block);
    if (!units.empty()) block->erase("units");
  }
}

}  // namespace creepcontact::config
