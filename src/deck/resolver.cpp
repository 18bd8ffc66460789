/// Sets and numbers of decks as nodes and elements.

#include <algorithm>

#include "loading.hpp"

namespace creepcontact::deck {
namespace {

Numbers resolved(const Deck& deck, const std::string& target, bool of_nodes) {
  const auto& sets = of_nodes ? deck.node_sets : deck.element_sets;
  if (const auto own = whole_number(target)) {
    // In an assembly a number is that of one of its own nodes.
    const std::int64_t in_assembly = *own + deck.assembly_offset;
    return {of_nodes && deck.node_of_number.contains(in_assembly) ? in_assembly : *own};
  }
  const auto found = sets.find(upper_case(target));
  if (found == sets.end()) {
    const auto own = deck.number_in_instance(target, of_nodes);
    return own ? Numbers{*own} : Numbers();
  }
  Numbers unique = found->second.members;
  std::ranges::sort(unique);
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  return unique;
}

}  // namespace

Numbers Resolver::nodes(const std::string& target) const {
  Numbers found = resolved(deck_, target, true);
  if (found.size() == 1)
    if (const auto other = deck_.same_as.find(found.front()); other != deck_.same_as.end())
      found.front() = other->second;
  std::erase_if(found, [&](std::int64_t node) { return !deck_.node_of_number.contains(node); });
  return found;
}

Numbers Resolver::elements(const std::string& target) const {
  Numbers found = resolved(deck_, target, false);
  std::erase_if(found, [&](std::int64_t element) { return !deck_.element_of_number.contains(element); });
  return found;
}

}  // namespace creepcontact::deck
