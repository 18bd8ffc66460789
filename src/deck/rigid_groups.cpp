#include "rigid_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "element_faces.hpp"

namespace creepcontact::deck {

namespace {

/// The card that says what a coupling is: the next one.
const RawCard* kind_of_coupling(const Deck& deck, std::size_t coupling) {
  if (coupling + 1 >= deck.cards.size()) return nullptr;
  const std::string& name = deck.cards[coupling + 1].card.name;
  return name == "KINEMATIC" || name == "DISTRIBUTING" ? &deck.cards[coupling + 1] : nullptr;
}

/// Degrees of freedom that lines "first, last" name; all if there are none. @param at  field of the first
std::set<int> freedoms(const RawCard& kind, std::size_t at = 0) {
  std::set<int> result;
  for (const std::vector<std::string>& line : kind.data) {
    const auto first = line.size() <= at ? std::nullopt : whole_number(line[at]);
    const auto last = line.size() > at + 1 ? whole_number(line[at + 1]) : first;
    if (first && last)
      for (std::int64_t k = *first; k <= std::min<std::int64_t>(*last, 6); ++k) result.insert(static_cast<int>(k));
  }
  if (result.empty()) result = {1, 2, 3, 4, 5, 6};
  return result;
}

bool has_all_displacements(const std::set<int>& freedoms) {
  return freedoms.contains(1) && freedoms.contains(2) && freedoms.contains(3);
}

/// *KINEMATIC COUPLING, the older card: lines "node or set, first, last".
std::optional<RigidGroup> kinematic_coupling(const RawCard& raw, const Resolver& resolver,
                                             std::vector<Note>& impossible) {
  const auto refuse = [&](const std::string& why) {
    impossible.push_back({raw.card.place, raw.card.name, why});
    return std::nullopt;
  };
  RigidGroup group;
  group.place = raw.card.place;
  group.card = raw.card.name;
  const Numbers reference = resolver.nodes(raw.card.value("REFNODE"));
  if (reference.size() != 1)
    return refuse(fmt::format("REF NODE is '{}', which is not one node", raw.card.value("REFNODE")));
  group.reference = reference.front();
  if (!has_all_displacements(freedoms(raw, 1))) return refuse("some displacements alone are not known; 1 to 3 are");
  for (const std::vector<std::string>& line : raw.data) {
    const Numbers nodes = resolver.nodes(line.empty() ? "" : line[0]);
    if (nodes.empty()) return refuse(fmt::format("there is no node or set '{}'", line.empty() ? "" : line[0]));
    group.nodes.insert(group.nodes.end(), nodes.begin(), nodes.end());
  }
  std::ranges::sort(group.nodes);
  group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
  if (group.nodes.empty()) return refuse("it has no nodes");
  return group;
}

std::optional<RigidGroup> coupling_of(const Deck& deck, const Resolver& resolver, std::size_t at,
                                      std::vector<Note>& impossible) {
  const RawCard& raw = deck.cards[at];
  const auto refuse = [&](const std::string& why) { impossible.push_back({raw.card.place, raw.card.name, why}); };
  const RawCard* const kind = kind_of_coupling(deck, at);
  if (kind == nullptr) {
    refuse("*KINEMATIC or *DISTRIBUTING must follow");
    return std::nullopt;
  }
  RigidGroup group;
  group.place = raw.card.place;
  group.card = raw.card.name;
  const Numbers reference = resolver.nodes(raw.card.value("REFNODE"));
  if (reference.size() != 1) {
    refuse(fmt::format("REF NODE is '{}', which is not one node", raw.card.value("REFNODE")));
    return std::nullopt;
  }
  group.reference = reference.front();
  if (!has_all_displacements(freedoms(*kind))) {
    refuse(fmt::format("*{} of some displacements is not known; those of 1 to 3 are", kind->card.name));
    return std::nullopt;
  }
  const std::string surface = upper_case(raw.card.value("SURFACE"));
  for (const ElementFace& face : faces_named(deck, surface, impossible)) {
    const Numbers nodes = face_nodes(deck, face);
    group.nodes.insert(group.nodes.end(), nodes.begin(), nodes.end());
  }
  if (group.nodes.empty()) {
    refuse(fmt::format("the surface '{}' has no faces of elements", raw.card.value("SURFACE")));
    return std::nullopt;
  }
  std::ranges::sort(group.nodes);
  group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
  if (kind->card.name == "DISTRIBUTING") group.surface = surface;
  return group;
}

}  // namespace

std::vector<RigidGroup> find_rigid_groups(const Deck& deck, const Resolver& resolver, std::vector<Note>& impossible) {
  std::vector<RigidGroup> groups;
  for (std::size_t at = 0; at < deck.cards.size(); ++at) {
    const RawCard& raw = deck.cards[at];
    if (raw.card.name == "COUPLING")
      if (std::optional<RigidGroup> group = coupling_of(deck, resolver, at, impossible))
        groups.push_back(std::move(*group));
    if ((raw.card.name == "KINEMATIC" || raw.card.name == "DISTRIBUTING") &&
        (at == 0 || deck.cards[at - 1].card.name != "COUPLING"))
      impossible.push_back({raw.card.place, raw.card.name, "it must follow *COUPLING"});
    if (raw.card.name == "KINEMATIC COUPLING")
      if (std::optional<RigidGroup> group = kinematic_coupling(raw, resolver, impossible))
        groups.push_back(std::move(*group));
    if (raw.card.name != "RIGID BODY") continue;
    const auto refuse = [&](const std::string& why) { impossible.push_back({raw.card.place, raw.card.name, why}); };
    RigidGroup group;
    group.place = raw.card.place;
    for (const char* parameter : {"NSET", "TIENSET", "PINNSET"})
      if (!raw.card.value(parameter).empty()) {
        const Numbers nodes = resolver.nodes(raw.card.value(parameter));
        group.nodes.insert(group.nodes.end(), nodes.begin(), nodes.end());
      }
    for (const std::int64_t element : resolver.elements(raw.card.value("ELSET"))) {
      const auto nodes = element_nodes(deck, element);
      group.nodes.insert(group.nodes.end(), nodes.begin(), nodes.end());
    }
    if (group.nodes.empty()) {
      refuse("it has no nodes; NSET or ELSET names them");
      continue;
    }
    std::ranges::sort(group.nodes);
    group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
    const auto node = [&](const char* parameter) -> std::optional<std::int64_t> {
      const std::string& given = raw.card.value(parameter);
      if (given.empty()) return std::nullopt;
      const Numbers found = resolver.nodes(given);
      if (found.size() == 1) return found.front();
      refuse(fmt::format("{} is '{}', which is not one node", parameter, given));
      return std::nullopt;
    };
    const auto reference = node("REFNODE");
    if (!reference) {
      if (raw.card.value("REFNODE").empty()) refuse("REF NODE is missing");
      continue;
    }
    group.reference = *reference;
    group.rotation = node("ROTNODE");
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace creepcontact::deck
