#include "deck_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "card_parameters.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "note_lines.hpp"

namespace creepcontact::deck {
namespace {

constexpr std::size_t most_mistakes = 50;

std::vector<std::string> names(const std::map<std::string, DeckReader::Rule>& rules) {
  std::vector<std::string> result;
  result.reserve(rules.size());
  for (const auto& [name, rule] : rules) result.push_back(name);
  return result;
}

}  // namespace

Place ElementBlock::place(std::size_t element) const {
  const auto after = std::ranges::upper_bound(cards, element, {}, [](const auto& card) { return card.first; });
  return after == cards.begin() ? Place() : (after - 1)->second;
}

bool Deck::is_only_mesh() const {
  return steps.empty() && materials.empty() && sections.empty() && cards.empty() && !elements.empty();
}

std::optional<std::int64_t> Deck::number_in_instance(const std::string& name, bool is_node) const {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto own = whole_number(name.substr(dot + 1));
  const auto found = instances.find(upper_case(name.substr(0, dot)));
  if (!own || found == instances.end()) return std::nullopt;
  return *own + (is_node ? found->second.node : found->second.element);
}

bool Deck::conducts() const {
  return std::ranges::any_of(steps, &Step::conducts);
}

bool Deck::deforms() const {
  return std::ranges::any_of(steps, &Step::deforms);
}

DeckReader::DeckReader() = default;

void DeckReader::card(const Card& given) {
  finish_card();
  current_ = given;
  const auto* found = rule_or_null(given.name);
  if (found == nullptr) {
    deck_.impossible.push_back({given.place, given.name,
                                fmt::format("an unknown card, which may change the results{}; remove it if it does "
                                            "not, or begin it with ** if it is a comment",
                                            did_you_mean(given.name, names(rules())))});
    return;
  }
  current_.name = found->first;
  const Card& card = current_;
  const Rule& rule = found->second;
  switch (rule.kind) {
    case Rule::Kind::read:
      if (!is_in_place(card, rule)) return;
      check_parameters(card);
      (this->*rule.handler)(card);
      return;
    case Rule::Kind::kept:
      if (!is_in_place(card, rule)) return;
      check_parameters(card);
      keep(card, rule);
      return;
    case Rule::Kind::silent:
      if (parameters_of(card.name) != nullptr) check_parameters(card);
      return;
    case Rule::Kind::without_influence:
      if (without_influence_.empty()) first_without_influence_ = card.place;
      if (std::ranges::find(without_influence_, card.name) == without_influence_.end())
        without_influence_.push_back(card.name);
      return;
    case Rule::Kind::left_out:
      deck_.left_out.push_back({card.place, card.name, rule.text});
      return;
    case Rule::Kind::impossible:
      deck_.impossible.push_back({card.place, card.name, rule.text});
      return;
    case Rule::Kind::of_heat:
      of_heat_.push_back({card.place, card.name, rule.text});
      return;
  }
}

bool DeckReader::is_in_place(const Card& card, const Rule& rule) {
  const auto refuse = [&](const char* why) {
    deck_.impossible.push_back({card.place, card.name, why});
    return false;
  };
  if (rule.where == Where::model && in_step())
    return refuse("it belongs before the first *STEP; within a step it is not known");
  if (rule.where == Where::step && !in_step()) return refuse("it belongs between *STEP and *END STEP");
  if (rule.kind != Rule::Kind::kept) return true;
  if (into_ != &deck_)
    return refuse("within a part or an instance it is not known; write it after the instances, with their names");
  if (!in_step() && !deck_.steps.empty()) return refuse("it is between two steps; it belongs into one, or before all");
  return true;
}

void DeckReader::check_parameters(const Card& card) {
  const std::map<std::string, Parameter>& known = *parameters_of(card.name);
  for (const auto& [name, value] : card.parameters) {
    const auto refuse = [&](const std::string& why) { deck_.impossible.push_back({card.place, card.name, why}); };
    const auto found = known.find(name);
    if (found == known.end()) {
      std::vector<std::string> all;
      all.reserve(known.size());
      for (const auto& [letters, parameter] : known) all.push_back(parameter.name);
      refuse(fmt::format("{}: an unknown parameter, which may change the results{}; remove it if it does not", name,
                         did_you_mean(name, all)));
      continue;
    }
    const Parameter& parameter = found->second;
    const std::string given = letters_of(value);
    if (!parameter.values.empty() && !value.empty() &&
        std::ranges::none_of(parameter.values, [&](const std::string& one) { return letters_of(one) == given; }))
      refuse(fmt::format("{}={} is not known; {} {}", parameter.name, value, fmt::join(parameter.values, ", "),
                         parameter.values.size() > 1 ? "are" : "is"));
    else if (parameter.use == Parameter::Use::impossible)
      refuse(fmt::format("{}: {}", parameter.name, parameter.text));
    else if (parameter.use == Parameter::Use::left_out)
      deck_.left_out.push_back({card.place, card.name, fmt::format("{}: {}", parameter.name, parameter.text)});
  }
}

void DeckReader::keep(const Card& card, const Rule& rule) {
  std::vector<RawCard>& cards = in_step() ? deck_.steps.back().cards : deck_.cards;
  cards.push_back({card, {}, {}});
  on_data_ = [this, &cards, most = rule.most_fields](const DataLine& line) {
    if (most > 0 && line.fields.size() > most)
      mistake(line.place,
              fmt::format("{} fields; only the first {} have a meaning that is known", line.fields.size(), most));
    cards.back().data.emplace_back(line.fields.begin(), line.fields.end());
    cards.back().places.push_back(line.place);
  };
}

void DeckReader::data(const DataLine& line) {
  if (std::exchange(current_.goes_on, false))
    if (const auto* known = parameters_of(current_.name);
        known != nullptr && !line.fields.empty() && std::ranges::all_of(line.fields, [&](std::string_view field) {
          return known->contains(letters_of(std::string(field)));
        }))
      return mistake(line.place,
                     fmt::format("'{}' is a parameter of the card; write it into the card's line", line.field(0)));
  if (on_data_) on_data_(line);
}

void DeckReader::finish_card() {
  on_data_ = nullptr;
  if (!pending_.empty()) {
    mistake(pending_place_, fmt::format("element {} of type {} has {} of its {} nodes", pending_.front(),
                                        current_.value("TYPE"), pending_.size() - 1, n_element_nodes()));
    pending_.clear();
  }
}

Deck DeckReader::finish() {
  finish_card();
  add_late_members();
  set_skins_apart();
  drop_missing_members(deck_);
  if (!without_influence_.empty())
    deck_.left_out.push_back({first_without_influence_, fmt::format("{}", fmt::join(without_influence_, ", *")),
                              "without influence on the results"});
  for (Note& note : of_heat_) {
    if (deck_.conducts()) {
      deck_.impossible.push_back(std::move(note));
    } else {
      note.consequence = "it does not act, for no step computes temperatures";
      deck_.left_out.push_back(std::move(note));
    }
  }
  if (step_open_) mistake(deck_.steps.back().place, "the step has no *END STEP; the deck may be cut off");
  if (into_ != &deck_) mistake(current_.place, "the part or instance does not end; the deck may be cut off");
  for (const Section& section : deck_.sections)
    if (!deck_.element_sets.contains(section.elements))
      mistake(section.place, fmt::format("there is no element set '{}'", section.elements), "SOLID SECTION");
  for (const auto& [name, material] : deck_.materials)
    if (material.cyclic_hardening && (!material.plastic || material.hardening != "COMBINED"))
      deck_.impossible.push_back({material.cyclic_hardening->place, "CYCLIC HARDENING",
                                  "it belongs to *PLASTIC, HARDENING=COMBINED; other plasticity has its own table"});
  for (const GasketSection& section : deck_.gasket_sections)
    if (!deck_.element_sets.contains(section.elements))
      mistake(section.place, fmt::format("there is no element set '{}'", section.elements), "GASKET SECTION");
  refuse_missing_nodes();
  if (deck_.elements.empty() && deck_.impossible.empty() && mistakes_.empty())
    mistake(current_.place, "the deck has no elements");
  if (!mistakes_.empty()) {
    std::vector<std::string> lines = lines_of_notes(mistakes_);
    if (lines.size() > most_mistakes) {
      const std::size_t rest = lines.size() - most_mistakes;
      lines.resize(most_mistakes);
      lines.push_back(fmt::format("and {} more", rest));
    }
    throw ConfigError(fmt::format("{}", fmt::join(lines, "\n")));
  }
  for (ElementBlock& block : deck_.elements) {  // vectors that have grown have up to twice the memory that they need
    block.nodes.shrink_to_fit();
    block.numbers.shrink_to_fit();
  }
  deck_.positions.shrink_to_fit();
  deck_.node_numbers.shrink_to_fit();
  for (auto* sets : {&deck_.node_sets, &deck_.element_sets})
    for (auto& [name, set] : *sets) set.members.shrink_to_fit();
  return std::move(deck_);
}

void DeckReader::mistake(const Place& place, const std::string& what, const std::string& card) {
  mistakes_.push_back({place, card.empty() ? current_.name : card, what});
}

/// One line for all of them: most often a file with nodes is missing.
void DeckReader::refuse_missing_nodes() {
  std::set<std::int64_t> missing;
  std::string first;
  Place place;
  const auto look = [&](std::int64_t element, std::int64_t node, const Place& at) {
    if (deck_.node_of_number.contains(node) || !missing.insert(node).second || missing.size() > 1) return;
    first = fmt::format("element {} has the node {}, which no *NODE defines", element, node);
    place = at;
  };
  for (const GasketElement& gasket : deck_.gaskets)
    for (const Numbers& side : gasket.sides)
      for (const std::int64_t node : side) look(gasket.number, node, gasket.place);
  for (const ElementBlock& block : deck_.elements) {
    const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
    for (std::size_t i = 0; i < block.nodes.size(); ++i) look(block.numbers[i / n], block.nodes[i], block.place(i / n));
  }
  if (missing.empty()) return;
  const std::size_t others = missing.size() - 1;
  mistake(place, first + (others > 0 ? fmt::format("; nor {} other nodes of elements", others) : ""), "ELEMENT");
}

std::string DeckReader::required(const Card& card, const std::string& parameter) {
  if (card.value(parameter).empty()) mistake(card.place, fmt::format("{} is missing", parameter));
  return card.value(parameter);
}

std::optional<std::int64_t> DeckReader::label(const DataLine& line, std::string_view field, const char* what) {
  constexpr std::int64_t most = 999'999'999;  // as in Abaqus; those of many instances together have a place in 64 bits
  const std::optional<std::int64_t> found = whole_number(field);
  if (found && *found >= 1 && *found <= most) return found;
  mistake(line.place, found ? fmt::format("'{}' is not {}: 1 to {}", field, what, most)
                            : fmt::format("'{}' is not {}", field, what));
  return std::nullopt;
}

std::optional<double> DeckReader::real(const DataLine& line, std::size_t field) {
  if (line.field(field).empty()) return 0.0;
  const std::optional<double> found = number(line.field(field));
  if (!found) mistake(line.place, fmt::format("'{}' is not a number", line.field(field)));
  return found;
}

namespace {

CardSink into(DeckReader& reader) {
  return {[&](const Card& card) { reader.card(card); }, [&](const DataLine& line) { reader.data(line); }};
}

}  // namespace

Deck read_deck(const std::filesystem::path& path) {
  DeckReader reader;
  read_cards(path, into(reader));
  return reader.finish();
}

Deck read_deck(std::istream& text, const std::filesystem::path& name) {
  DeckReader reader;
  read_cards(text, name, into(reader));
  return reader.finish();
}

}  // namespace creepcontact::deck
