/// Materials and amplitudes.

#include <fmt/format.h>

#include "deck_reader.hpp"

namespace creepcontact::deck {

void DeckReader::material(const Card& card) {
  const std::string name = required(card, "NAME");
  material_ = &deck_.materials[upper_case(name)];
  material_->name = name;
  material_->place = card.place;
}

void DeckReader::table(std::optional<Table> Material::*property, const Card& card, std::size_t columns) {
  if (material_ == nullptr) return mistake(card.place, "it belongs to a material; there is no *MATERIAL before it");
  std::optional<Table>& table = material_->*property;
  table = Table{card.place, {}};
  on_data_ = [this, &table, columns](const DataLine& line) {
    std::vector<double> row;
    for (std::size_t i = 0; i < std::max(line.fields.size(), columns); ++i) {
      const std::optional<double> value = real(line, i);
      if (!value) return;
      row.push_back(*value);
    }
    table->rows.push_back(std::move(row));
  };
}

bool DeckReader::is_isotropic(const Card& card, const std::string& property) {
  const std::string type = upper_case(card.value("TYPE"));
  if (type.empty() || type == "ISO" || type == "ISOTROPIC") return true;
  deck_.impossible.push_back(
      {card.place, card.name, fmt::format("{0} of type {1}; only isotropic {0} is known", property, type)});
  return false;
}

void DeckReader::elastic(const Card& card) {
  if (is_isotropic(card, "elasticity")) table(&Material::elastic, card, 2);
}

void DeckReader::expansion(const Card& card) {
  if (!is_isotropic(card, "thermal expansion")) return;
  table(&Material::expansion, card, 1);
  if (material_ != nullptr && !card.value("ZERO").empty()) {
    const std::optional<double> zero = number(card.value("ZERO"));
    if (!zero) return mistake(card.place, fmt::format("ZERO: '{}' is not a number", card.value("ZERO")));
    material_->expansion_zero = *zero;
  }
}

void DeckReader::density(const Card& card) {
  table(&Material::density, card, 1);
}

void DeckReader::creep(const Card& card) {
  if (material_ != nullptr && !card.value("LAW").empty()) material_->creep_law = upper_case(card.value("LAW"));
  table(&Material::creep, card, 2);
}

void DeckReader::physical_constants(const Card& card) {
  if (const std::string& given = card.value("ABSOLUTEZERO"); !given.empty()) {
    const std::optional<double> zero = number(given);
    if (!zero) return mistake(card.place, fmt::format("ABSOLUTE ZERO: '{}' is not a number", given));
    deck_.absolute_zero = *zero;
  }
}

void DeckReader::amplitude(const Card& card) {
  const std::string name = required(card, "NAME");
  if (name.empty()) return;
  for (const char* unknown : {"DEFINITION", "VALUE"})
    if (const std::string given = upper_case(card.value(unknown));
        !given.empty() && given != "TABULAR" && given != "RELATIVE")
      deck_.impossible.push_back(
          {card.place, card.name, fmt::format("{}={}; only tables of factors are known", unknown, given)});
  Amplitude& amplitude = deck_.amplitudes[upper_case(name)];
  amplitude = {name, upper_case(card.value("TIME")) == "TOTAL TIME", {}};
  on_data_ = [this, &amplitude](const DataLine& line) {
    if (line.fields.size() % 2 != 0) return mistake(line.place, "expected pairs of a time and a factor");
    for (std::size_t i = 0; i < line.fields.size(); i += 2) {
      const auto time = real(line, i), factor = real(line, i + 1);
      if (!time || !factor) return;
      if (!amplitude.points.empty() && *time < amplitude.points.back().first)
        return mistake(line.place, "the times of an amplitude must increase");
      amplitude.points.emplace_back(*time, *factor);
    }
  };
}

}  // namespace creepcontact::deck
