/// Sets and numbers of decks as nodes and elements.

#include <algorithm>

#include "loading.hpp"

namespace creepcontact::deck {
namespace {

Numbers resolved(const std::string& target, const std::map<std::string, Set>& sets) {
  if (const auto own = whole_number(target)) return {*own};
  const auto found = sets.find(upper_case(target));
  if (found == sets.end()) return {};
  Numbers unique = found->second.members;
  std::ranges::sort(unique);
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  return unique;
}

}  // namespace

Numbers Resolver::nodes(const std::string& target) const {
  Numbers found = resolved(target, deck_.node_sets);
  if (found.size() == 1)
    if (const auto other = deck_.same_as.find(found.front()); other != deck_.same_as.end())
      found.front() = other->second;
  std::erase_if(found, [&](std::int64_t node) { return !deck_.node_of_number.contains(node); });
  return found;
}

Numbers Resolver::elements(const std::string& target) const {
  Numbers found = resolved(target, deck_.element_sets);
  std::erase_if(found, [&](std::int64_t element) { return !deck_.element_of_number.contains(element); });
  return found;
}

}  // namespace creepcontact::deck
