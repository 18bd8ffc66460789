/// Materials and amplitudes.

#include <fmt/format.h>

#include <algorithm>

#include "card_parameters.hpp"
#include "deck_reader.hpp"

namespace creepcontact::deck {

void DeckReader::material(const Card& card) {
  const std::string name = required(card, "NAME");
  material_ = &deck_.materials[upper_case(name)];
  behavior_ = nullptr;
  material_->name = name;
  material_->place = card.place;
}

bool DeckReader::is_short_enough(const DataLine& line, std::size_t most) {
  if (line.fields.size() <= most) return true;
  mistake(line.place, fmt::format("{} values; at most {} are known", line.fields.size(), most));
  return false;
}

void DeckReader::table(std::optional<Table> Material::*property, const Card& card, std::size_t columns,
                       std::size_t most) {
  if (material_ == nullptr) return mistake(card.place, "it belongs to a material; there is no *MATERIAL before it");
  table(material_->*property, card, fmt::format("material '{}'", material_->name), columns, most);
}

void DeckReader::table(std::optional<Table>& table, const Card& card, const std::string& owner, std::size_t columns,
                       std::size_t most) {
  if (table) return mistake(card.place, fmt::format("the {} has one already", owner));
  table = Table{card.place, {}};
  on_data_ = [this, &table, columns, most](const DataLine& line) {
    std::vector<double> row;
    if (!is_short_enough(line, most)) return;
    for (std::size_t i = 0; i < std::max(line.fields.size(), columns); ++i) {
      const std::optional<double> value = real(line, i);
      if (!value) return;
      row.push_back(*value);
    }
    table->rows.push_back(std::move(row));
  };
}

void DeckReader::table_of_long_rows(std::optional<Table> Material::*property, const Card& card, std::size_t columns) {
  if (material_ == nullptr) return mistake(card.place, "it belongs to a material; there is no *MATERIAL before it");
  std::optional<Table>& table = material_->*property;
  if (table) return mistake(card.place, fmt::format("the material '{}' has one already", material_->name));
  table = Table{card.place, {}};
  constexpr std::size_t of_line = 8;
  on_data_ = [this, &table, columns](const DataLine& line) {
    if (table->rows.empty() || table->rows.back().size() >= columns) table->rows.emplace_back();
    std::vector<double>& row = table->rows.back();
    // A row begins with a full line; in the last line of it the temperature may follow.
    if (!is_short_enough(line, row.empty() ? of_line : columns - row.size() + 1)) return;
    const std::size_t n = std::max(row.empty() ? of_line : columns - row.size(), line.fields.size());
    for (std::size_t i = 0; i < n; ++i) {
      const std::optional<double> value = real(line, i);
      if (!value) return;
      row.push_back(*value);
    }
  };
}

namespace {

bool is_isotropic(const std::string& type) {
  return type.empty() || type == "ISO" || type == "ISOTROPIC";
}
bool is_orthotropic(const std::string& type) {
  return type == "ORTHO" || type == "ORTHOTROPIC";
}
std::string type_of(const Card& card) {
  std::string type = upper_case(card.value("TYPE"));
  std::erase(type, ' ');
  return type;
}

}  // namespace

void DeckReader::refuse_type(const Card& card, const std::string& property, const std::string& known) {
  deck_.impossible.push_back(
      {card.place, card.name, fmt::format("{} of type {} is not known; {} are", property, card.value("TYPE"), known)});
}

void DeckReader::elastic(const Card& card) {
  const std::string type = type_of(card);
  if (is_isotropic(type)) return table(&Material::elastic, card, 2, 3);
  const bool by_matrix = is_orthotropic(type);
  if (!by_matrix && type != "ENGINEERINGCONSTANTS")
    return refuse_type(card, "elasticity", "ISO, ORTHO and ENGINEERING CONSTANTS");
  constexpr std::size_t n_constants = 9;
  table_of_long_rows(&Material::elastic, card, n_constants);
  if (material_ != nullptr)
    material_->elasticity = by_matrix ? Elasticity::stiffness_matrix : Elasticity::engineering_constants;
}

void DeckReader::expansion(const Card& card) {
  const std::string type = type_of(card);
  const bool along_axes = is_orthotropic(type);
  if (!along_axes && !is_isotropic(type)) return refuse_type(card, "thermal expansion", "ISO and ORTHO");
  table(&Material::expansion, card, along_axes ? 3 : 1, along_axes ? 4 : 2);
  if (material_ != nullptr) material_->expands_along_axes = along_axes;
  if (material_ != nullptr && !card.value("ZERO").empty()) {
    const std::optional<double> zero = number(card.value("ZERO"));
    if (!zero) return mistake(card.place, fmt::format("ZERO: '{}' is not a number", card.value("ZERO")));
    material_->expansion_zero = *zero;
  }
}

void DeckReader::potential(const Card& card) {
  table(&Material::potential, card, 6, 7);
}

void DeckReader::orientation(const Card& card) {
  const std::string name = required(card, "NAME");
  if (name.empty()) return;
  Orientation& made = into_->orientations[upper_case(name)];
  made = {.place = card.place};
  const std::string system = upper_case(card.value("SYSTEM"));
  made.is_cylindrical = system == "CYLINDRICAL";
  if (!made.is_cylindrical && !system.empty() && system != "RECTANGULAR")
    made.problem = fmt::format("SYSTEM={} is not known; RECTANGULAR and CYLINDRICAL are", system);
  const std::string definition = upper_case(card.value("DEFINITION"));
  if (!definition.empty() && definition != "COORDINATES")
    made.problem = fmt::format("DEFINITION={} is not known; COORDINATES is", definition);
  on_data_ = [this, &made, n_lines = 0](const DataLine& line) mutable {
    if (n_lines++ == 1) {
      const std::optional<double> about = real(line, 0), by = real(line, 1);
      if (!about || !by) return;
      if (*about != 1 && *about != 2 && *about != 3)
        return mistake(line.place, fmt::format("'{}' is not a local axis: 1, 2 or 3", line.field(0)));
      made.turned_about = static_cast<int>(*about);
      made.turned_by = *by;
      return;
    }
    if (!number(line.field(0))) {  // the name of a distribution
      if (made.problem.empty()) made.problem = "only axes by two points are known";
      return;
    }
    for (std::size_t i = 0; i < 9; ++i) {
      const std::optional<double> value = real(line, i);
      if (!value) return;
      const auto component = static_cast<Eigen::Index>(i % 3);
      if (i < 6)
        (i < 3 ? made.a : made.b)[component] = *value;
      else if (!made.is_cylindrical)  // a third point is the origin
        for (Vector3* point : {&made.a, &made.b}) (*point)[component] -= *value;
    }
  };
}

void DeckReader::density(const Card& card) {
  table(&Material::density, card, 1, 2);
}

void DeckReader::conductivity(const Card& card) {
  const std::string type = type_of(card);
  const bool along_axes = is_orthotropic(type);
  if (!along_axes && !is_isotropic(type)) return refuse_type(card, "conductivity", "ISO and ORTHO");
  table(&Material::conductivity, card, along_axes ? 3 : 1, along_axes ? 4 : 2);
  if (material_ != nullptr) material_->conducts_along_axes = along_axes;
}

void DeckReader::specific_heat(const Card& card) {
  table(&Material::specific_heat, card, 1, 2);
}

void DeckReader::creep(const Card& card) {
  if (material_ != nullptr) {
    if (!card.value("LAW").empty()) material_->creep_law = upper_case(card.value("LAW"));
    material_->creep_time_only = upper_case(card.value("TIME")) == "CREEP";
  }
  table(&Material::creep, card, 2, 6);
}

void DeckReader::plastic(const Card& card) {
  constexpr std::size_t of_line = 8;
  if (material_ != nullptr) {
    if (const std::string& given = card.value("HARDENING"); !given.empty()) material_->hardening = upper_case(given);
    if (const std::string& given = card.value("NUMBERBACKSTRESSES"); !given.empty()) {
      const std::optional<double> n = number(given);
      if (!n || !(*n >= 1) || *n > 10)
        return mistake(card.place, fmt::format("NUMBER BACKSTRESSES: '{}' is not a number from 1 to 10", given));
      material_->back_stresses = static_cast<std::size_t>(*n);
    }
    material_->by_table = material_->hardening != "COMBINED" || !card.has("DATATYPE");
    if (!material_->by_table && 1 + 2 * material_->back_stresses > of_line)
      return table_of_long_rows(&Material::plastic, card, 1 + 2 * material_->back_stresses);
  }
  const bool by_table = material_ == nullptr || material_->by_table;
  table(&Material::plastic, card, by_table ? 2 : 1 + 2 * material_->back_stresses, of_line);
}

void DeckReader::cyclic_hardening(const Card& card) {
  table(&Material::cyclic_hardening, card, 2, 3);
}

void DeckReader::physical_constants(const Card& card) {
  const auto constant = [&](const char* parameter, const char* name) -> std::optional<double> {
    const std::string& given = card.value(parameter);
    if (given.empty()) return std::nullopt;
    const std::optional<double> found = number(given);
    if (!found) mistake(card.place, fmt::format("{}: '{}' is not a number", name, given));
    return found;
  };
  if (const auto zero = constant("ABSOLUTEZERO", "ABSOLUTE ZERO")) deck_.absolute_zero = *zero;
  if (const auto sigma = constant("STEFANBOLTZMANN", "STEFAN BOLTZMANN")) deck_.stefan_boltzmann = sigma;
}

void DeckReader::gasket_behavior(const Card& card) {
  const std::string name = required(card, "NAME");
  behavior_ = &deck_.gasket_behaviors[upper_case(name)];
  material_ = &behavior_->material;
  material_->name = name;
  material_->place = card.place;
}

void DeckReader::gasket_thickness_behavior(const Card& card) {
  if (behavior_ == nullptr) return mistake(card.place, "it belongs below *GASKET BEHAVIOR; there is none before it");
  const bool unloads = upper_case(card.value("DIRECTION")) == "UNLOADING";
  if (upper_case(card.value("TYPE")) == "DAMAGE") behavior_->is_damage = true;
  const auto value = [&](const char* parameter) {
    const auto given = number(card.value(parameter));
    if (!given) mistake(card.place, fmt::format("{}: '{}' is not a number", parameter, card.value(parameter)));
    return given;
  };
  if (card.has("SLOPEDROP")) behavior_->slope_drop = value("SLOPEDROP").value_or(0);
  if (card.has("YIELDONSET")) behavior_->yield_onset = value("YIELDONSET");
  const std::size_t columns = unloads ? 4 : 3;  // with the temperature
  table(unloads ? behavior_->unloading : behavior_->loading, card, fmt::format("gasket '{}'", behavior_->material.name),
        columns, columns);
}

void DeckReader::amplitude(const Card& card) {
  const std::string name = required(card, "NAME");
  if (name.empty()) return;
  const auto [made, is_new] = deck_.amplitudes.try_emplace(upper_case(name));
  if (!is_new) return mistake(card.place, fmt::format("the amplitude '{}' exists already", name));
  Amplitude& amplitude = made->second;
  amplitude.name = name;
  amplitude.total_time = letters_of(card.value("TIME")) == "TOTALTIME";
  const auto shift = [&](const char* parameter) {
    const std::optional<double> given = card.has(parameter) ? number(card.value(parameter)) : 0.0;
    if (!given) mistake(card.place, fmt::format("{}: '{}' is not a number", parameter, card.value(parameter)));
    return given.value_or(0);
  };
  amplitude.shift_time = shift("SHIFTX");
  amplitude.shift_factor = shift("SHIFTY");
  on_data_ = [this, &amplitude](const DataLine& line) {
    if (line.fields.size() % 2 != 0) return mistake(line.place, "expected pairs of a time and a factor");
    for (std::size_t i = 0; i < line.fields.size(); i += 2) {
      const auto time = real(line, i), factor = real(line, i + 1);
      if (!time || !factor) return;
      const double shifted = *time + amplitude.shift_time;
      if (!amplitude.points.empty() && shifted < amplitude.points.back().first)
        return mistake(line.place, "the times of an amplitude must increase");
      amplitude.points.emplace_back(shifted, *factor + amplitude.shift_factor);
    }
  };
}

}  // namespace creepcontact::deck
