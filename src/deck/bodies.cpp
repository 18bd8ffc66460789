#include "bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "creepcontact/base/disjoint_sets.hpp"

namespace creepcontact::deck {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// A name that TOML and messages take, and that is not used yet.
std::string free_name(const std::string& wanted, std::set<std::string>& used) {
  std::string name = wanted;
  for (int i = 2; !used.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
  return name;
}

}  // namespace

Bodies find_bodies(const Deck& deck, std::vector<Note>& impossible) {
  std::map<std::int64_t, std::size_t> section_of;  // by element
  for (std::size_t s = 0; s < deck.sections.size(); ++s) {
    const Section& section = deck.sections[s];
    if (!deck.materials.contains(section.material))
      impossible.push_back(
          {section.place, "SOLID SECTION", fmt::format("there is no material '{}'", section.material)});
    for (const std::int64_t element : deck.element_sets.at(section.elements).members) section_of[element] = s;
  }

  Numbers elements;
  std::vector<std::size_t> section;
  DisjointSets components(deck.element_of_number.size());
  std::unordered_map<std::int64_t, std::map<std::size_t, std::size_t>> first_at;  // by node and section: an element
  Bodies result;
  for (const ElementBlock& block : deck.elements) {
    const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
    for (std::size_t e = 0; e < block.numbers.size(); ++e) {
      const auto found = section_of.find(block.numbers[e]);
      const std::size_t own = found == section_of.end() ? none : found->second;
      if (own == none) {
        impossible.push_back(
            {Place(), "ELEMENT", fmt::format("element {} belongs to no *SOLID SECTION", block.numbers[e])});
        return result;
      }
      const std::size_t index = elements.size();
      elements.push_back(block.numbers[e]);
      section.push_back(own);
      for (std::size_t i = 0; i < n; ++i) {
        auto& at = first_at[block.nodes[e * n + i]];
        // Sections of one material are one body.
        std::size_t same = none;
        for (const auto& [other, element] : at)
          if (deck.sections[other].material == deck.sections[own].material) same = element;
        if (same != none) components.join(index, same);
        if (!at.empty() && same == none) result.share_nodes = true;
        at.try_emplace(own, index);
      }
    }
  }

  std::map<std::size_t, Numbers> members;
  std::map<std::size_t, std::size_t> section_of_body;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    members[components.find(i)].push_back(elements[i]);
    section_of_body.try_emplace(components.find(i), section[i]);
  }
  std::map<Numbers, std::string> set_of;  // by sorted members
  for (const auto& [key, set] : deck.element_sets) {
    Numbers sorted = set.members;
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    set_of.try_emplace(std::move(sorted), set.name);
  }
  std::set<std::string> used;
  for (auto& [root, numbers] : members) {
    std::ranges::sort(numbers);
    const Section& own = deck.sections[section_of_body[root]];
    const auto named = set_of.find(numbers);
    const std::string name = named != set_of.end() ? named->second : deck.element_sets.at(own.elements).name;
    result.bodies.push_back({free_name(name, used), own.material, own.thickness, std::move(numbers)});
  }
  return result;
}

}  // namespace creepcontact::deck
