#include "rigid_groups.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "element_faces.hpp"

namespace creepcontact::deck {

std::vector<RigidGroup> find_rigid_groups(const Deck& deck, const Resolver& resolver, std::vector<Note>& impossible) {
  std::vector<RigidGroup> groups;
  for (const RawCard& raw : deck.cards) {
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
