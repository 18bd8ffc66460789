/// Parts and instances of Abaqus as one model.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "deck_reader.hpp"

namespace creepcontact::deck {
namespace {

std::int64_t largest(const Numbers& numbers) {
  return numbers.empty() ? 0 : *std::ranges::max_element(numbers);
}

/// The two data lines of *INSTANCE: a translation, and a rotation in degrees about an axis through two points.
Eigen::Affine3d motion(const std::vector<std::vector<double>>& lines) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  const auto at = [&](std::size_t line, std::size_t i) { return i < lines[line].size() ? lines[line][i] : 0.0; };
  if (!lines.empty()) result.translate(Vector3(at(0, 0), at(0, 1), at(0, 2)));
  if (lines.size() > 1) {
    const Vector3 a(at(1, 0), at(1, 1), at(1, 2)), b(at(1, 3), at(1, 4), at(1, 5));
    if ((b - a).norm() > 0) {
      const Eigen::AngleAxisd turn(at(1, 6) * std::numbers::pi / 180, (b - a).normalized());
      result = Eigen::Translation3d(a) * turn * Eigen::Translation3d(-a) * result;
    }
  }
  return result;
}

}  // namespace

void DeckReader::part(const Card& card) {
  if (into_ != &deck_) return mistake(card.place, "the part or instance before it does not end");
  into_ = &parts_[upper_case(required(card, "NAME"))];
}

void DeckReader::end_part(const Card& card) {
  if (into_ == &deck_ || into_ == &instance_deck_) return mistake(card.place, "there is no *PART before it");
  add_late_members();
  into_ = &deck_;
}

void DeckReader::instance(const Card& card) {
  if (into_ != &deck_) return mistake(card.place, "the part or instance before it does not end");
  const std::string part = required(card, "PART"), name = required(card, "NAME");
  const auto found = parts_.find(upper_case(part));
  if (found == parts_.end()) return mistake(card.place, fmt::format("there is no part '{}'", part));
  instance_deck_ = found->second;
  instance_name_ = name;
  instance_moves_.clear();
  into_ = &instance_deck_;
  on_data_ = [this](const DataLine& line) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < line.fields.size(); ++i) numbers.push_back(real(line, i).value_or(0));
    instance_moves_.push_back(std::move(numbers));
  };
}

void DeckReader::end_instance(const Card& card) {
  if (into_ != &instance_deck_) return mistake(card.place, "there is no *INSTANCE before it");
  add_late_members();
  into_ = &deck_;
  merge_instance();
}

void DeckReader::merge_instance() {
  drop_missing_members(instance_deck_);
  const std::string written = instance_name_ + ".", prefix = upper_case(written);
  Numbers all_elements;
  for (const ElementBlock& block : deck_.elements)
    all_elements.insert(all_elements.end(), block.numbers.begin(), block.numbers.end());
  for (const GasketElement& gasket : deck_.gaskets) all_elements.push_back(gasket.number);
  for (const SkinElements& skin : deck_.skins)
    all_elements.insert(all_elements.end(), skin.numbers.begin(), skin.numbers.end());
  const InstanceOffsets offsets{largest(deck_.node_numbers), largest(all_elements)};
  if (!deck_.instances.emplace(upper_case(instance_name_), offsets).second)
    mistake(current_.place, fmt::format("the instance '{}' exists already", instance_name_));
  const Eigen::Affine3d moved = motion(instance_moves_);
  for (std::size_t i = 0; i < instance_deck_.positions.size(); ++i) {
    const std::int64_t number = instance_deck_.node_numbers[i] + offsets.node;
    deck_.node_of_number.insert(number, static_cast<std::uint32_t>(deck_.positions.size()));
    deck_.node_numbers.push_back(number);
    deck_.positions.emplace_back(moved * instance_deck_.positions[i]);
  }
  for (const ElementBlock& block : instance_deck_.elements) {
    auto into =
        std::ranges::find_if(deck_.elements, [&](const ElementBlock& one) { return one.type.name == block.type.name; });
    if (into == deck_.elements.end()) into = deck_.elements.insert(into, {block.type, {}, {}});
    for (const auto& [first, place] : block.cards) into->cards.emplace_back(into->numbers.size() + first, place);
    for (const std::int64_t number : block.numbers) {
      deck_.element_of_number.insert(number + offsets.element,
                                     {static_cast<std::uint32_t>(into - deck_.elements.begin()),
                                      static_cast<std::uint32_t>(into->numbers.size())});
      into->numbers.push_back(number + offsets.element);
    }
    for (const std::int64_t node : block.nodes) into->nodes.push_back(node + offsets.node);
  }
  for (SkinElements skin : instance_deck_.skins) {
    for (std::int64_t& number : skin.numbers) number += offsets.element;
    for (std::int64_t& node : skin.nodes) node += offsets.node;
    deck_.skins.push_back(std::move(skin));
  }
  for (GasketElement gasket : instance_deck_.gaskets) {
    gasket.number += offsets.element;
    for (Numbers& side : gasket.sides)
      for (std::int64_t& node : side) node += offsets.node;
    deck_.gaskets.push_back(std::move(gasket));
  }
  const auto add_sets = [&](const std::map<std::string, Set>& from, std::map<std::string, Set>& to,
                            std::int64_t offset) {
    for (const auto& [name, set] : from) {
      Set& made = to[prefix + name];
      made.name = written + set.name;
      for (const std::int64_t member : set.members) made.members.push_back(member + offset);
    }
  };
  add_sets(instance_deck_.node_sets, deck_.node_sets, offsets.node);
  add_sets(instance_deck_.element_sets, deck_.element_sets, offsets.element);
  for (const auto& [name, surface] : instance_deck_.surfaces) {
    Surface& made = deck_.surfaces[prefix + name];
    made = surface;
    made.name = written + surface.name;
    for (SurfaceEntry& entry : made.entries) entry.target = prefix + upper_case(entry.target);
  }
  for (Section section : instance_deck_.sections) {
    section.elements = prefix + section.elements;
    if (instance_deck_.orientations.contains(section.orientation)) section.orientation = prefix + section.orientation;
    deck_.sections.push_back(std::move(section));
  }
  for (GasketSection section : instance_deck_.gasket_sections) {
    section.elements = prefix + section.elements;
    deck_.gasket_sections.push_back(std::move(section));
  }
  for (const auto& [name, orientation] : instance_deck_.orientations) {
    Orientation& made = deck_.orientations[prefix + name];
    made = orientation;
    for (Vector3* point : {&made.a, &made.b})
      *point = made.is_cylindrical ? Vector3{moved * *point} : Vector3{moved.linear() * *point};
  }
  for (const Note& note : instance_deck_.left_out) deck_.left_out.push_back(note);
  for (const Note& note : instance_deck_.impossible) deck_.impossible.push_back(note);
  instance_deck_ = {};
}

}  // namespace creepcontact::deck
