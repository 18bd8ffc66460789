#include "deck_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"

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

DeckReader::DeckReader() = default;

void DeckReader::card(const Card& given) {
  finish_card();
  current_ = given;
  const auto* found = rule_or_null(given.name);
  if (found == nullptr) {
    deck_.left_out.push_back(
        {given.place, given.name,
         fmt::format("an unknown card{}; it is not taken into account", did_you_mean(given.name, names(rules())))});
    return;
  }
  current_.name = found->first;
  const Card& card = current_;
  const Rule& rule = found->second;
  switch (rule.kind) {
    case Rule::Kind::read:
      (this->*rule.handler)(card);
      return;
    case Rule::Kind::silent:
      return;
    case Rule::Kind::left_out:
      deck_.left_out.push_back({card.place, card.name, rule.text});
      return;
    case Rule::Kind::impossible:
      deck_.impossible.push_back({card.place, card.name, rule.text});
      return;
    case Rule::Kind::kept: {
      std::vector<RawCard>& cards = in_step() ? deck_.steps.back().cards : deck_.cards;
      cards.push_back({card, {}, {}});
      on_data_ = [&cards](const DataLine& line) {
        cards.back().data.emplace_back(line.fields.begin(), line.fields.end());
        cards.back().places.push_back(line.place);
      };
      return;
    }
  }
}

void DeckReader::data(const DataLine& line) {
  if (on_data_) on_data_(line);
}

void DeckReader::finish_card() {
  on_data_ = nullptr;
  if (!pending_.empty()) {
    mistake(pending_place_, fmt::format("element {} of type {} has {} of its {} nodes", pending_.front(),
                                        block_->type.name, pending_.size() - 1, mesh::n_nodes(block_->type.cell)));
    pending_.clear();
  }
}

Deck DeckReader::finish() {
  finish_card();
  if (step_open_) mistake(deck_.steps.back().place, "the step has no *END STEP; the deck may be cut off");
  if (into_ != &deck_) mistake(current_.place, "the part or instance does not end; the deck may be cut off");
  std::set<std::int64_t> missing;
  for (const ElementBlock& block : deck_.elements) {
    const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
    for (std::size_t i = 0; i < block.nodes.size(); ++i)
      if (!deck_.node_of_number.contains(block.nodes[i]) && missing.insert(block.nodes[i]).second)
        mistake(
            fmt::format("element {} has the node {}, which no *NODE defines", block.numbers[i / n], block.nodes[i]));
  }
  if (deck_.elements.empty() && deck_.impossible.empty() && mistakes_.empty())
    mistake(current_.place, "the deck has no elements");
  if (!mistakes_.empty()) {
    std::string all;
    for (const std::string& one : mistakes_) all += (all.empty() ? "" : "\n") + one;
    if (n_mistakes_ > mistakes_.size()) all += fmt::format("\nand {} more", n_mistakes_ - mistakes_.size());
    throw ConfigError(all);
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

void DeckReader::mistake(const std::string& message) {
  ++n_mistakes_;
  if (mistakes_.size() < most_mistakes) mistakes_.push_back(message);
}

void DeckReader::mistake(const Place& place, const std::string& what) {
  Card at = current_;
  at.place = place;
  mistake(at.message(what));
}

std::string DeckReader::required(const Card& card, const std::string& parameter) {
  if (card.value(parameter).empty()) mistake(card.place, fmt::format("{} is missing", parameter));
  return card.value(parameter);
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
