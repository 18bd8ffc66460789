#include "bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "creepcontact/base/disjoint_sets.hpp"
#include "loading.hpp"

namespace creepcontact::deck {
namespace {

/// One element of each kind at every node.
class OwnersOfNodes {
 public:
  explicit OwnersOfNodes(const Deck& deck) : deck_(deck), first_(deck.positions.size()) {}

  struct Found {
    std::optional<std::uint32_t> same;  ///< an element there of the same kind
    bool is_shared = false;             ///< only others are there
  };
  /// Adds an element, and says what was at the node before. @param kind  equal for those of one body
  Found add(std::int64_t node, std::uint32_t kind, std::uint32_t element) {
    const std::uint32_t place = deck_.node_of_number.at(node);
    Owner& first = first_[place];
    if (first.kind == none) {
      first = {kind, element};
      return {};
    }
    if (first.kind == kind) return {first.element, false};
    std::vector<Owner>& others = others_[place];
    for (const Owner& other : others)
      if (other.kind == kind) return {other.element, false};
    others.push_back({kind, element});
    return {std::nullopt, true};
  }

 private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  struct Owner {
    std::uint32_t kind = none, element = none;
  };
  const Deck& deck_;
  std::vector<Owner> first_;                                      // by node
  std::unordered_map<std::uint32_t, std::vector<Owner>> others_;  // where several bodies meet
};

/// A name that TOML and messages take, and that is not used yet.
std::string free_name(const std::string& wanted, std::set<std::string>& used) {
  std::string name = wanted;
  for (int i = 2; !used.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
  return name;
}

/// An isotropic material has no axes.
std::string orientation_that_counts(const Deck& deck, const Section& section) {
  const auto material = deck.materials.find(section.material);
  return material != deck.materials.end() && material->second.has_axes() ? section.orientation : "";
}

/// Equal numbers for sections of one material with the same axes: together they are one body.
std::vector<std::size_t> kinds_of_sections(const Deck& deck) {
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::vector<std::size_t> kinds;
  for (const Section& section : deck.sections)
    kinds.push_back(
        known.try_emplace({section.material, orientation_that_counts(deck, section)}, known.size()).first->second);
  return kinds;
}

/// Numbers of elements in which the same sources of heat act, by element; 0 is without: a source is one of a body.
std::unordered_map<std::int64_t, std::uint32_t> kinds_of_sources(const Deck& deck) {
  const Resolver resolver(deck);
  std::map<std::int64_t, std::set<std::string>> targets;  // by element
  if (!deck.conducts()) return {};
  for (const Step& step : deck.steps)
    for (const RawCard& raw : step.cards) {
      if (raw.card.name != "DFLUX") continue;
      for (const std::vector<std::string>& line : raw.data)
        if (line.size() > 1 && upper_case(line[1]) == "BF")
          for (const std::int64_t element : resolver.elements(line[0])) targets[element].insert(upper_case(line[0]));
    }
  std::map<std::set<std::string>, std::uint32_t> known;
  std::unordered_map<std::int64_t, std::uint32_t> kinds;
  for (const auto& [element, own] : targets)
    kinds[element] = known.try_emplace(own, static_cast<std::uint32_t>(known.size()) + 1).first->second;
  return kinds;
}

}  // namespace

Bodies find_bodies(const Deck& deck, std::vector<Note>& impossible) {
  NumberMap<std::uint32_t> section_of;                    // by element
  for (std::size_t s = deck.sections.size(); s-- > 0;) {  // the last one counts
    const Section& section = deck.sections[s];
    if (!deck.materials.contains(section.material))
      impossible.push_back(
          {section.place, "SOLID SECTION", fmt::format("there is no material '{}'", section.material)});
    for (const std::int64_t element : deck.element_sets.at(section.elements).members)
      section_of.insert(element, static_cast<std::uint32_t>(s));
  }

  const std::vector<std::size_t> kinds = kinds_of_sections(deck);
  const std::unordered_map<std::int64_t, std::uint32_t> sources = kinds_of_sources(deck);
  std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> known;
  Numbers elements;
  std::vector<std::uint32_t> section;
  DisjointSets components(deck.element_of_number.size());
  OwnersOfNodes owners(deck);
  Bodies result;
  for (const ElementBlock& block : deck.elements) {
    const auto n = static_cast<std::size_t>(mesh::n_nodes(block.type.cell));
    for (std::size_t e = 0; e < block.numbers.size(); ++e) {
      const std::uint32_t* own = section_of.find_or_null(block.numbers[e]);
      if (own == nullptr) {
        impossible.push_back({block.place(e), "ELEMENT",
                              fmt::format("element {} belongs to no *SOLID SECTION; add it to the element set of one",
                                          block.numbers[e])});
        return result;
      }
      const auto index = static_cast<std::uint32_t>(elements.size());
      elements.push_back(block.numbers[e]);
      section.push_back(*own);
      const auto source = sources.find(block.numbers[e]);
      const std::pair of_body(kinds[*own], source == sources.end() ? 0U : source->second);
      const std::uint32_t kind = known.try_emplace(of_body, static_cast<std::uint32_t>(known.size())).first->second;
      for (std::size_t i = 0; i < n; ++i) {
        const auto [same, is_shared] = owners.add(block.nodes[e * n + i], kind, index);
        if (same) components.join(index, *same);
        result.share_nodes = result.share_nodes || is_shared;
      }
    }
  }

  std::map<std::size_t, Numbers> members;
  std::map<std::size_t, std::size_t> section_of_body;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    members[components.find(i)].push_back(elements[i]);
    section_of_body.try_emplace(components.find(i), section[i]);
  }
  const auto name_of = [&](const Numbers& sorted) -> const std::string* {
    for (const auto& [key, set] : deck.element_sets) {
      // Members may repeat, but hardly all of them.
      if (set.members.size() < sorted.size() || set.members.size() > 2 * sorted.size()) continue;
      Numbers own = set.members;
      std::ranges::sort(own);
      own.erase(std::unique(own.begin(), own.end()), own.end());
      if (own == sorted) return &set.name;
    }
    return nullptr;
  };
  std::set<std::string> used;
  for (auto& [root, numbers] : members) {
    std::ranges::sort(numbers);
    const Section& own = deck.sections[section_of_body[root]];
    const std::string* named = name_of(numbers);
    const std::string name = named != nullptr ? *named : deck.element_sets.at(own.elements).name;
    result.bodies.push_back({free_name(name, used), own.material, own.thickness, std::move(numbers),
                             orientation_that_counts(deck, own), own.place});
  }
  return result;
}

}  // namespace creepcontact::deck
