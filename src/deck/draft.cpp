#include "draft.hpp"

#include <algorithm>

#include "element_faces.hpp"

namespace creepcontact::deck {

Draft::Draft(const Deck& of, std::string called, std::vector<Note> known)
    : deck(of),
      name(std::move(called)),
      impossible(std::move(known)),
      left_out(of.left_out),
      resolver(of),
      frames(of, resolver, impossible),
      mesh(of) {
  impossible.insert(impossible.begin(), of.impossible.begin(), of.impossible.end());
  std::vector<bool> is_used(deck.positions.size(), false);
  for (const ElementBlock& block : deck.elements)
    for (const std::int64_t node : block.nodes) is_used[deck.node_of_number.at(node)] = true;
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (is_used[i]) used.push_back(deck.node_numbers[i]);
  std::ranges::sort(used);
}

const std::array<std::string, 2>& Draft::groups_of(const PretensionSection& section) {
  const auto [found, is_new] = section_groups.try_emplace(section.reference);
  if (is_new)
    found->second = {mesh.add_faces("bolt_section", section.faces),
                     mesh.add_faces("bolt_section_opposite", section.opposite)};
  return found->second;
}

const std::vector<std::string>& Draft::bodies_at(std::int64_t node) {
  if (bodies_at_.empty())
    for (const DeckBody& body : bodies.bodies)
      for (const std::int64_t element : body.elements)
        for (const std::int64_t own : element_nodes(deck, element))
          if (auto& all = bodies_at_[own]; all.empty() || all.back() != body.name) all.push_back(body.name);
  return bodies_at_[node];
}

std::string Draft::name_for(const Numbers& nodes, const std::string& general) const {
  for (const auto& [key, set] : deck.node_sets)
    if (set.members.size() >= nodes.size() && resolver.nodes(key) == nodes) return set.name;
  return general;
}

Place Draft::first(const std::string& card) const {
  const auto all = cards(card);
  return all.empty() ? Place() : all.front()->card.place;
}

std::vector<const RawCard*> Draft::cards(const std::string& card) const {
  std::vector<const RawCard*> result;
  for (const RawCard& raw : deck.cards)
    if (raw.card.name == card) result.push_back(&raw);
  for (const Step& step : deck.steps)
    for (const RawCard& raw : step.cards)
      if (raw.card.name == card) result.push_back(&raw);
  return result;
}

}  // namespace creepcontact::deck
